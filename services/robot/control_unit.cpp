#include "services/robot/control_unit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace race::robot {
namespace {

constexpr double kFollowingError = 0.03;  // rad; more means that something pushes the arm off its path
constexpr double kArrived = 0.005;        // rad; the weight of a carried part costs up to 0.003
constexpr double kStanding = 0.02;        // rad/s
constexpr double kPatience = 1.0;         // s that an arrival may take longer than planned

double largest_difference(const Joints& a, const Joints& b) {
  double largest = 0;
  for (std::size_t i = 0; i < kJoints; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

ControlSettings lwr_settings() {
  ControlSettings settings;
  settings.planner.acceleration = {6, 6, 8, 8, 12, 12, 12};
  settings.planner.preferred = {0, -0.35, 0, 1.6, 0, -1.19, 0};
  settings.planner.tool_speed = 0.5;
  settings.planner.tool_acceleration = 2.0;
  settings.planner.tool_turning = 1.5;
  settings.planner.turning_acceleration = 6.0;
  settings.braking = {8, 8, 12, 12, 20, 20, 20};
  settings.contact_thresholds = {8, 10, 6, 8, 3, 3, 2};
  settings.damping = {2, 2, 1.5, 1.5, 0.5, 0.3, 0.3};
  return settings;
}

ControlUnit::ControlUnit(ArmModel arm, const ControlSettings& settings, const Joints& q)
    : arm_(std::move(arm)),
      settings_(settings),
      q_(q),
      torques_(arm_.gravity(q)),
      brake_(q, Joints{}, settings.braking),
      observer_(arm_, settings.observer_gain),
      detector_(settings.contact_thresholds) {}

tl::expected<void, Refusal> ControlUnit::move(const MoveCommand& command) {
  if (behavior_ != Behavior::position)
    return tl::unexpected(Refusal{"behavior", "", "the robot moves only with the behavior 'position'"});
  if (motion_) return tl::unexpected(Refusal{"busy", "", "the robot is moving"});
  auto planned = plan(arm_, settings_.planner, brake_.goal(), command);
  if (!planned) return tl::unexpected(planned.error());
  motion_ = std::move(*planned);
  motion_time_ = 0;
  return {};
}

void ControlUnit::stop() {
  motion_.reset();
  outcome_.reset();
  behavior_ = Behavior::position;
  brake_ = Braking(q_, dq_, settings_.braking);
  brake_time_ = 0;
}

void ControlUnit::set_behavior(Behavior behavior) {
  assert(!motion_);
  if (behavior == behavior_) return;
  behavior_ = behavior;
  brake_ = Braking(q_, dq_, settings_.braking);
  brake_time_ = 0;
}

const Joints& ControlUnit::control(const Joints& q, const Joints& dq) {
  q_ = q;
  dq_ = dq;
  observer_.update(q, dq, torques_, kPeriod);
  if (auto contact = detector_.update(observer_.torques())) contact_ = contact;

  if (behavior_ == Behavior::gravity_compensation) {
    torques_ = arm_.gravity(q);
    for (std::size_t i = 0; i < kJoints; ++i) torques_[i] -= settings_.damping[i] * dq[i];
  } else {
    const Reference reference = next_reference(q, dq);
    Joints command;
    const double stiffness = settings_.bandwidth * settings_.bandwidth;
    const double damping = 2 * settings_.bandwidth;
    for (std::size_t i = 0; i < kJoints; ++i) {
      command[i] = reference.ddq[i] + stiffness * (reference.q[i] - q[i]) + damping * (reference.dq[i] - dq[i]);
    }
    torques_ = arm_.inverse_dynamics(q, dq, command);
  }
  for (std::size_t i = 0; i < kJoints; ++i)
    torques_[i] = std::clamp(torques_[i], -arm_.limits().effort[i], arm_.limits().effort[i]);
  return torques_;
}

Reference ControlUnit::next_reference(const Joints& q, const Joints& dq) {
  if (!motion_ || brake_time_ < brake_.duration()) {
    const Reference reference = brake_.at(brake_time_);
    brake_time_ += kPeriod;
    return reference;
  }
  const Reference reference = motion_->at(motion_time_);
  const double overtime = motion_time_ - motion_->duration();
  motion_time_ += kPeriod;
  if (largest_difference(reference.q, q) > kFollowingError) {
    fail({"following_error", "", "something pushes the arm off its path"});
  } else if (overtime >= 0) {
    judge_arrival(overtime, q, dq);
  }
  return reference;
}

void ControlUnit::judge_arrival(double overtime, const Joints& q, const Joints& dq) {
  const bool arrived = largest_difference(motion_->goal(), q) < kArrived;
  if (arrived && largest_difference(dq, Joints{}) < kStanding) {
    brake_ = Braking(motion_->goal(), Joints{}, settings_.braking);
    motion_.reset();
    outcome_.emplace(std::nullopt);
  } else if (overtime > kPatience) {
    fail({"not_reached", "", "something keeps the arm from its goal"});
  }
}

void ControlUnit::fail(Refusal refusal) {
  stop();
  outcome_.emplace(std::move(refusal));
}

std::optional<std::optional<Refusal>> ControlUnit::take_outcome() { return std::exchange(outcome_, std::nullopt); }

std::optional<Contact> ControlUnit::take_contact() { return std::exchange(contact_, std::nullopt); }

RobotState ControlUnit::state() const {
  const Joints& tau_ext = observer_.torques();
  return {q_, dq_, torques_, tau_ext, arm_.forward(q_), wrench_at_tool(arm_, q_, tau_ext)};
}

}  // namespace race::robot
