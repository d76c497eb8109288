#include "services/robot/control_unit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "services/robot/control_unit_internal.h"
#include "services/robot/impedance.h"

namespace race::robot {
namespace {

constexpr double kArrived = 0.005;      // rad; the weight of a carried part costs up to 0.003
constexpr double kArrivedSoftly = 0.1;  // rad, with an impedance: it may be pushed
constexpr double kSlowLasts = 0.5;      // s that a reflex slows down after its signal has ended
constexpr double kOfSpeedLimit = 0.98;  // for the reference: the arm follows it with a small error

void add(Joints& sum, const Joints& more, double share = 1) {
  for (std::size_t i = 0; i < kJoints; ++i) sum[i] += share * more[i];
}

Refusal interruption(const Incident& incident) {
  std::string signal(name(incident.signal));
  std::string reaction(name(incident.reflex->reaction));
  std::string message = "interrupted by the reflex on " + signal + ": " + reaction;
  return {std::move(signal), "", std::move(message), std::move(reaction)};
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

ControlUnit::ControlUnit(ArmModel arm, const ControlSettings& settings, const Joints& q, KeepsClear keeps_clear)
    : arm_(std::move(arm)),
      settings_(settings),
      keeps_clear_(std::move(keeps_clear)),
      q_(q),
      torques_(arm_.gravity(q)),
      brake_(q, Joints{}, settings.braking),
      button_(static_cast<int>(std::lround(kJogHold / kPeriod))),
      observer_(arm_, settings.observer_gain),
      reflexes_(arm_, settings.contact_thresholds, settings.braking) {
  reflexes_.set(behavior_.reflexes);
}

tl::expected<void, Refusal> ControlUnit::move(const MoveCommand& command, const std::optional<Behavior>& behavior) {
  const Operational& wanted = behavior ? behavior->operational : behavior_.operational;
  if (wanted.mode == Mode::gravity_compensation)
    return tl::unexpected(Refusal{"behavior", "", "the robot does not move by itself in gravity compensation"});
  if (moving()) return tl::unexpected(Refusal{"busy", "", "the robot is moving"});
  const bool brakes = wanted.mode != behavior_.operational.mode || activity_ == Activity::retreat;
  const Joints start = brakes ? Braking(q_, dq_, settings_.braking).goal() : brake_.goal();

  if (command.kind == MotionKind::free) {
    auto search = begin_search(arm_, settings_.planner, keeps_clear_, start, command, settings_.seed + searches_);
    if (!search) return tl::unexpected(search.error());
    if (brakes) brake_and_hold();
    if (behavior) set_behavior(*behavior);
    ++searches_;
    search_ = std::move(*search);
    activity_ = Activity::plan;
    return {};
  }
  auto planned = plan(arm_, settings_.planner, start, command);
  if (!planned) return tl::unexpected(planned.error());
  if (brakes) brake_and_hold();
  if (behavior) set_behavior(*behavior);
  follow(std::move(*planned));
  return {};
}

void ControlUnit::follow(Trajectory trajectory) {
  if (behavior_.operational.speed) keep_tool_speed(arm_, *behavior_.operational.speed, trajectory);
  path_.emplace(std::move(trajectory), settings_.braking, rate());
  limit_rate();
  overtime_ = 0;
  activity_ = Activity::follow;
}

void ControlUnit::set_tool_speed_limit(std::optional<double> tool_speed) {
  if (tool_speed) *tool_speed *= kOfSpeedLimit;
  if (std::exchange(tool_speed_limit_, tool_speed) != tool_speed) limit_rate();
}

void ControlUnit::limit_rate() {
  rate_limit_.reset();
  if (path_ && tool_speed_limit_) rate_limit_.emplace(arm_, path_->trajectory(), settings_.braking, *tool_speed_limit_);
}

/// The rate of the path for the next cycle, forwards or backwards.
double ControlUnit::limited(double rate) const {
  if (!rate_limit_) return rate;
  const double most = rate_limit_->at(path_->next_time(kPeriod));
  return std::clamp(rate, -most, most);
}

void ControlUnit::stop() {
  end_guided_behavior();
  brake_and_hold();
  outcome_.reset();
  hold_by_position();
}

void ControlUnit::hold_by_position() {
  behavior_ = held_by_position(behavior_);
  reflexes_.go_on_with(behavior_.reflexes);
}

void ControlUnit::brake_and_hold() {
  activity_ = Activity::hold;
  search_.reset();
  path_.reset();
  jogging_.reset();
  returning_.reset();
  offset_.reset();
  offset_left_ = 0;
  brake_ = Braking(q_, dq_, settings_.braking);
  brake_time_ = 0;
}

void ControlUnit::set_behavior(const Behavior& behavior) {
  assert(!moving());
  if (behavior.operational.mode != behavior_.operational.mode) brake_and_hold();
  behavior_ = behavior;
  reflexes_.set(behavior.reflexes);
  offset_.reset();
  offset_left_ = kBlendTime;
}

const Joints& ControlUnit::control(const Joints& q, const Joints& dq) {
  q_ = q;
  dq_ = dq;
  observer_.update(q, dq, torques_, kPeriod);
  for (const Incident& incident : reflexes_.update(q, dq, observer_.torques(), kPeriod)) {
    react(incident);
    incidents_.push_back(incident);
  }
  if (const double slowest = reflexes_.slowest(); slowest < 1) {
    slow_ = slowest;
    slow_left_ = kSlowLasts;
  } else if (slow_left_ > 0) {
    slow_left_ -= kPeriod;
    if (slow_left_ <= 0) slow_ = 1;
  }
  if (activity_ == Activity::guide && !button_.held()) settle();
  Joints torques = law(q, dq);
  button_.pass();
  blend_torques(torques);
  for (std::size_t i = 0; i < kJoints; ++i)
    torques_[i] = std::clamp(torques[i], -arm_.limits().effort[i], arm_.limits().effort[i]);
  return torques_;
}

void ControlUnit::react(const Incident& incident) {
  if (!incident.reflex || incident.reflex->reaction == Reaction::slow_down) return;
  const Reaction reaction = incident.reflex->reaction;
  const bool guides = activity_ == Activity::guide;
  const bool gives_way = behavior_.operational.mode == Mode::gravity_compensation && !guides;
  const bool holds = activity_ == Activity::hold || activity_ == Activity::settle;
  if (reaction == Reaction::gravity_compensation) {
    if (guides) return;  // it gives way already
    interrupt(interruption(incident));
    behavior_.operational.mode = Mode::gravity_compensation;
  } else if (reaction == Reaction::retreat && can_retreat()) {
    if (activity_ == Activity::follow) returning_ = interruption(incident);
    activity_ = Activity::retreat;
    back_left_ = incident.reflex->distance;
  } else if (!holds || gives_way) {
    if (reaction == Reaction::retreat && activity_ == Activity::retreat) return;
    interrupt(interruption(incident));
    if (gives_way) hold_by_position();
  }
}

void ControlUnit::interrupt(const Refusal& why) {
  const bool was_moving = moving();
  if (activity_ == Activity::jog || activity_ == Activity::guide) button_.interrupt(why);
  end_guided_behavior();
  const std::optional<Refusal> earlier = returning_;
  brake_and_hold();
  if (was_moving) outcome_.emplace(earlier ? *earlier : why);
}

bool ControlUnit::can_retreat() const {
  return path_ && !path_->at_start() && activity_ != Activity::retreat && override_ > 0;
}

double ControlUnit::rate() const { return override_ * slow_; }

Joints ControlUnit::law(const Joints& q, const Joints& dq) {
  const Operational& behavior = behavior_.operational;
  Joints torques;
  if (behavior.mode == Mode::gravity_compensation) {
    torques = arm_.gravity(q);
    for (std::size_t i = 0; i < kJoints; ++i) torques[i] -= settings_.damping[i] * dq[i];
    add(torques, limit_cushions(arm_, q, dq, brake_.goal()));
    return torques;
  }
  const Reference reference = next_reference(q, dq);
  if (behavior.mode == Mode::position) return position_law(q, dq, reference);
  torques = behavior.mode == Mode::joint_impedance ? joint_impedance(arm_, behavior, q, dq, reference)
                                                   : cartesian_impedance(arm_, behavior, q, dq, reference);
  add(torques, limit_cushions(arm_, q, dq, reference.q));
  return torques;
}

Joints ControlUnit::position_law(const Joints& q, const Joints& dq, const Reference& reference) const {
  const double stiffness = settings_.bandwidth * settings_.bandwidth;
  const double damping = 2 * settings_.bandwidth;
  Joints command;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double goal = std::clamp(reference.q[i], arm_.limits().lower[i], arm_.limits().upper[i]);
    command[i] = reference.ddq[i] + stiffness * (goal - q[i]) + damping * (reference.dq[i] - dq[i]);
  }
  return arm_.inverse_dynamics(q, dq, command);
}

void ControlUnit::blend_torques(Joints& torques) {
  if (offset_left_ <= 0) return;
  if (!offset_) {
    offset_ = torques_;
    add(*offset_, torques, -1);
  }
  const double left = offset_left_ / kBlendTime;
  add(torques, *offset_, left * left * (3 - 2 * left));
  offset_left_ -= kPeriod;
}

Reference ControlUnit::next_reference(const Joints& q, const Joints& dq) {
  if (activity_ == Activity::plan) search();
  const bool braking = brake_time_ < brake_.duration();
  if (activity_ == Activity::follow && !braking) return follow_path(q, dq);
  if (activity_ == Activity::retreat) return go_back(q);
  if (activity_ == Activity::jog) return follow_jog(q, dq);
  const Reference reference = brake_.at(brake_time_);
  brake_time_ += kPeriod;
  if (activity_ == Activity::settle && !braking && stands(dq)) {
    activity_ = Activity::hold;
    outcome_.emplace(std::nullopt);
  }
  return reference;
}

void ControlUnit::search() {
  const FreePath::State state = search_->path.work(settings_.checks_per_cycle);
  if (state == FreePath::State::searching) return;
  if (state == FreePath::State::found) {
    follow(search_->trajectory());
  } else {
    activity_ = Activity::hold;
    outcome_.emplace(Refusal{"path", "target", "no way was found around what stands in between"});
  }
  search_.reset();
}

Reference ControlUnit::follow_path(const Joints& q, const Joints& dq) {
  const Reference reference = path_->advance(limited(rate()), kPeriod);
  const bool stiff = behavior_.operational.mode == Mode::position;
  if (stiff && largest_difference(reference.q, q) > kFollowingError) {
    interrupt({"following_error", "", "something pushes the arm off its path"});
  } else if (path_->at_end()) {
    check_arrival(q, dq);
  }
  return reference;
}

void ControlUnit::check_arrival(const Joints& q, const Joints& dq) {
  const bool stiff = behavior_.operational.mode == Mode::position;
  const Joints& goal = path_->trajectory().goal();
  const bool arrived = largest_difference(goal, q) < (stiff ? kArrived : kArrivedSoftly);
  overtime_ += kPeriod;
  if (arrived && largest_difference(dq, Joints{}) < kStanding) {
    brake_ = Braking(goal, Joints{}, settings_.braking);
    activity_ = Activity::hold;
    outcome_.emplace(std::nullopt);
  } else if (overtime_ > kArrivalTimeout) {
    interrupt({"not_reached", "", "something keeps the arm from its goal"});
  }
}

Reference ControlUnit::go_back(const Joints& q) {
  const Joints braking_way = path_->stopping_way();
  const double stopping = tool_way(arm_, q, braking_way);
  const Reference reference = path_->advance(back_left_ > stopping ? limited(-override_) : 0, kPeriod);
  Joints step = reference.dq;
  for (double& part : step) part *= kPeriod;
  back_left_ -= path_->backwards() ? tool_way(arm_, q, step) : 0;
  if (largest_difference(reference.q, q) > 2 * kFollowingError) {  // pushed from behind, too
    interrupt({"following_error", "", "something pushes the arm off its path"});
  } else if (path_->at_start() || (path_->standing() && back_left_ <= stopping)) {
    brake_ = Braking(reference.q, Joints{}, settings_.braking);
    activity_ = Activity::hold;
    if (auto why = std::exchange(returning_, std::nullopt)) outcome_.emplace(std::move(*why));
  }
  return reference;
}

std::optional<std::optional<Refusal>> ControlUnit::take_outcome() { return std::exchange(outcome_, std::nullopt); }

std::vector<Incident> ControlUnit::take_incidents() { return std::exchange(incidents_, {}); }

RobotState ControlUnit::state() const {
  const Joints& tau_ext = observer_.torques();
  return {q_, dq_, torques_, tau_ext, arm_.forward(q_), wrench_at_tool(arm_, q_, tau_ext)};
}

}  // namespace race::robot
