// Of ControlUnit: what moves while a person holds a button: jogging (jogging.h), and guiding by a hand that leads the
// arm.
#include <algorithm>
#include <cmath>
#include <utility>

#include "services/robot/control_unit.h"
#include "services/robot/control_unit_internal.h"

namespace race::robot {

/// After an interruption, the button is to be let go of first.
tl::expected<void, Refusal> ControlUnit::check_let_go() {
  if (!button_.interruption()) return {};
  button_.call();
  return tl::unexpected(*button_.interruption());
}

tl::expected<void, Refusal> ControlUnit::jog(const JogVelocity& wanted) {
  if (auto let_go = check_let_go(); !let_go) return let_go;
  const JogLimits limits = jog_limits(arm_, settings_.planner.acceleration, settings_.braking);
  if (auto fits = check_jog(wanted, limits); !fits) return fits;
  if (behavior_.operational.mode == Mode::gravity_compensation)
    return tl::unexpected(Refusal{"behavior", "", "the robot does not move by itself in gravity compensation"});
  if (activity_ != Activity::jog) {
    if (moving()) return tl::unexpected(Refusal{"busy", "", "the robot is moving"});
    if (activity_ == Activity::retreat) brake_and_hold();
    path_.reset();
    jogging_.emplace(arm_, limits, brake_.at(brake_time_));
    activity_ = Activity::jog;
  }
  jogging_->set_velocity(wanted);
  button_.call();
  overtime_ = 0;
  return {};
}

tl::expected<void, Refusal> ControlUnit::guide() {
  if (auto let_go = check_let_go(); !let_go) return let_go;
  if (activity_ != Activity::guide) {
    if (behavior_.operational.mode == Mode::gravity_compensation)
      return tl::unexpected(Refusal{"behavior", "", "a hand leads the robot without a button in gravity compensation"});
    if (moving() && activity_ != Activity::settle) return tl::unexpected(Refusal{"busy", "", "the robot is moving"});
    brake_and_hold();
    after_guiding_ = std::exchange(behavior_, guided(behavior_));
    reflexes_.go_on_with(behavior_.reflexes);
    offset_left_ = kBlendTime;
    activity_ = Activity::guide;
  }
  button_.call();
  return {};
}

/// The button was let go of.
void ControlUnit::settle() {
  end_guided_behavior();
  brake_and_hold();
  overtime_ = 0;
  activity_ = Activity::settle;
}

void ControlUnit::end_guided_behavior() {
  if (!after_guiding_) return;
  behavior_ = *std::exchange(after_guiding_, std::nullopt);
  reflexes_.go_on_with(behavior_.reflexes);
}

/// Whether an arm that should stand does, or has been waited for long enough.
bool ControlUnit::stands(const Joints& dq) {
  overtime_ += kPeriod;
  return largest_difference(dq, Joints{}) < kStanding || overtime_ >= kArrivalTimeout;
}

Reference ControlUnit::follow_jog(const Joints& q, const Joints& dq) {
  const bool held = button_.held();
  const Reference reference = jogging_->advance(held ? rate() : 0, jog_tool_speed(), kPeriod);
  const bool stiff = behavior_.operational.mode == Mode::position;
  if (stiff && largest_difference(reference.q, q) > kFollowingError) {
    interrupt({"following_error", "", "something pushes the arm off its path"});
  } else if (!held && jogging_->standing()) {
    end_jog(dq);
  }
  return reference;
}

/// The lower of the limits from outside and of the behavior, if there is one.
std::optional<double> ControlUnit::jog_tool_speed() const {
  const std::optional<double>& of_behavior = behavior_.operational.speed;
  if (!tool_speed_limit_ || !of_behavior) return of_behavior ? of_behavior : tool_speed_limit_;
  return std::min(*of_behavior, *tool_speed_limit_);
}

void ControlUnit::end_jog(const Joints& dq) {
  if (!stands(dq)) return;
  brake_ = Braking(jogging_->place(), Joints{}, settings_.braking);
  activity_ = Activity::hold;
  jogging_.reset();
  outcome_.emplace(std::nullopt);
}

}  // namespace race::robot
