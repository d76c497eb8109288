#include "services/robot/planner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "services/robot/ik.h"

namespace race::robot {
namespace {

constexpr double kWaypointLength = 0.005;  // m between waypoints of a linear path
constexpr double kWaypointTurn = 0.03;     // rad
constexpr double kLargestJump = 0.25;      // rad per waypoint; more is another configuration of the arm
constexpr double kFarthest = 10.0;         // m; beyond it a number is a mistake of its unit

using Planned = tl::expected<Trajectory, Refusal>;

tl::unexpected<Refusal> refuse(std::string code, std::string argument, std::string message) {
  return tl::unexpected<Refusal>(Refusal{std::move(code), std::move(argument), std::move(message)});
}

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

Eigen::Quaterniond quaternion(const Pose& pose) {
  const auto& q = pose.orientation;
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
}

bool finite(const auto& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); });
}

tl::expected<void, Refusal> check_share(double share, const char* argument) {
  if (share > 0 && share <= 1) return {};
  return refuse("out_of_range", argument, std::string(argument) + " must be greater than 0 and at most 1");
}

tl::expected<Joints, Refusal> checked_joints(const ArmModel& arm, const Joints& target) {
  if (!finite(target)) return refuse("out_of_range", "target", "joint positions must be finite");
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double lower = arm.limits().lower[i];
    const double upper = arm.limits().upper[i];
    if (target[i] < lower || target[i] > upper) {
      return refuse("joint_limits", "target",
                    "joint " + std::to_string(i + 1) + " at " + text(target[i]) + " rad is outside of " + text(lower) +
                        " to " + text(upper));
    }
  }
  return target;
}

tl::expected<Pose, Refusal> checked_pose(Pose pose) {
  if (!finite(pose.position) || !finite(pose.orientation))
    return refuse("out_of_range", "target", "a pose must be finite");
  for (const double coordinate : pose.position) {
    if (std::abs(coordinate) > kFarthest)
      return refuse("unreachable", "target", "the position is farther than " + text(kFarthest) + " m away");
  }
  const double norm = quaternion(pose).norm();
  if (std::abs(norm - 1) > 1e-2) return refuse("out_of_range", "target", "the orientation is no unit quaternion");
  for (double& component : pose.orientation) component /= norm;
  return pose;
}

/// The pose that a Cartesian target means, seen from the start.
tl::expected<Pose, Refusal> target_pose(const ArmModel& arm, const Joints& start, const Target& target) {
  if (const auto* pose = std::get_if<Pose>(&target)) return checked_pose(*pose);
  Pose pose = arm.forward(start);
  const Offset& offset = std::get<Offset>(target);
  for (std::size_t i = 0; i < 3; ++i) pose.position[i] += offset.metres[i];
  return checked_pose(pose);
}

/// m that the target is farther from the shoulder than the stretched arm; at most 0 within its reach.
double beyond_reach(const ArmModel& arm, const Pose& target) {
  const Vec3& shoulder = arm.shoulder();
  return std::hypot(target.position[0] - shoulder[0], target.position[1] - shoulder[1],
                    target.position[2] - shoulder[2]) -
         arm.reach();
}

Refusal unreachable(const ArmModel& arm, const Pose& target) {
  const double beyond = beyond_reach(arm, target);
  if (beyond > 0) return {"unreachable", "target", "the target is " + text(beyond) + " m beyond the arm's reach"};
  return {"unreachable", "target", "no joint positions within the limits reach this pose"};
}

using Accept = std::function<bool(const Joints&)>;

/// `accept` is shown every posture that is found for the target.
tl::expected<Joints, Refusal> goal_of(const ArmModel& arm, const PlannerSettings& settings, const Joints& start,
                                      const Target& target, const Accept& accept = {}) {
  if (const auto* joints = std::get_if<Joints>(&target)) {
    auto checked = checked_joints(arm, *joints);
    if (checked && accept) accept(*checked);
    return checked;
  }
  const auto pose = target_pose(arm, start, target);
  if (!pose) return tl::unexpected(pose.error());
  IkOptions options;
  options.preferred = settings.preferred;
  const bool near = beyond_reach(arm, *pose) <= 0;
  if (const auto goal = near ? solve_ik(arm, *pose, start, options, accept) : std::nullopt) return *goal;
  return tl::unexpected(unreachable(arm, *pose));
}

Planned plan_linear(const ArmModel& arm, const PlannerSettings& settings, const Joints& start,
                    const MoveCommand& command, const MotionLimits& limits) {
  Pose goal;
  if (const auto* joints = std::get_if<Joints>(&command.target)) {
    const auto checked = checked_joints(arm, *joints);
    if (!checked) return tl::unexpected(checked.error());
    goal = arm.forward(*checked);
  } else {
    const auto pose = target_pose(arm, start, command.target);
    if (!pose) return tl::unexpected(pose.error());
    goal = *pose;
  }
  const Pose from = arm.forward(start);
  const double length = std::hypot(goal.position[0] - from.position[0], goal.position[1] - from.position[1],
                                   goal.position[2] - from.position[2]);
  const double turn = quaternion(from).angularDistance(quaternion(goal));
  const int steps = std::max(1, static_cast<int>(std::ceil(std::max(length / kWaypointLength, turn / kWaypointTurn))));

  std::vector<Joints> waypoints{start};
  for (int step = 1; step <= steps; ++step) {
    const double s = static_cast<double>(step) / steps;
    Pose pose = from;
    for (std::size_t i = 0; i < 3; ++i) pose.position[i] += s * (goal.position[i] - from.position[i]);
    const Eigen::Quaterniond turned = quaternion(from).slerp(s, quaternion(goal));
    pose.orientation = {turned.x(), turned.y(), turned.z(), turned.w()};
    IkOptions options;
    options.null_space_gain = 0.002;  // stay with the configuration the path began in, but drift off joint limits
    const auto q = solve_ik_from(arm, pose, waypoints.back(), options);
    bool jumps = !q;
    for (std::size_t i = 0; q && i < kJoints; ++i) jumps |= std::abs((*q)[i] - waypoints.back()[i]) > kLargestJump;
    if (jumps) {
      if (step == steps && !q) return tl::unexpected(unreachable(arm, goal));
      return refuse("path", "target", "the straight path cannot be followed beyond " + text(s * length) + " m");
    }
    waypoints.push_back(*q);
  }
  const std::vector<ToolLimits> tool = {
      {length, command.speed * settings.tool_speed, command.acceleration * settings.tool_acceleration},
      {turn, command.speed * settings.tool_turning, command.acceleration * settings.turning_acceleration}};
  return Trajectory(std::move(waypoints), limits, tool);
}

tl::expected<MotionLimits, Refusal> limits_of(const ArmModel& arm, const PlannerSettings& settings,
                                              const MoveCommand& command) {
  if (auto checked = check_share(command.speed, "speed"); !checked) return tl::unexpected(checked.error());
  if (auto checked = check_share(command.acceleration, "acceleration"); !checked)
    return tl::unexpected(checked.error());
  MotionLimits limits;
  for (std::size_t i = 0; i < kJoints; ++i) {
    limits.velocity[i] = command.speed * arm.limits().velocity[i];
    limits.acceleration[i] = command.acceleration * settings.acceleration[i];
  }
  return limits;
}

/// The largest of a few distances, at most FreeSearch::kMargin, that the arm keeps at `q`; nothing if it touches.
double kept_margin(const KeepsClear& keeps_clear, const Joints& q) {
  for (const double share : {1.0, 0.5, 0.25, 0.1}) {
    if (keeps_clear(q, share * FreeSearch::kMargin)) return share * FreeSearch::kMargin;
  }
  return 0;
}

}  // namespace

Planned plan(const ArmModel& arm, const PlannerSettings& settings, const Joints& start, const MoveCommand& command) {
  assert(command.kind != MotionKind::free);
  const auto limits = limits_of(arm, settings, command);
  if (!limits) return tl::unexpected(limits.error());
  if (command.kind == MotionKind::linear) return plan_linear(arm, settings, start, command, *limits);
  const auto goal = goal_of(arm, settings, start, command.target);
  if (!goal) return tl::unexpected(goal.error());
  return Trajectory({start, *goal}, *limits);
}

tl::expected<FreeSearch, Refusal> begin_search(const ArmModel& arm, const PlannerSettings& settings,
                                               const KeepsClear& keeps_clear, const Joints& start,
                                               const MoveCommand& command, unsigned seed) {
  const auto limits = limits_of(arm, settings, command);
  if (!limits) return tl::unexpected(limits.error());
  if (!keeps_clear) return refuse("path", "kind", "nothing is known of what stands around the arm");
  const double at_start = kept_margin(keeps_clear, start);
  if (at_start == 0) return refuse("path", "", "the arm, or what it carries, touches something where it stands");

  // Of the postures for the target the first that keeps the whole distance, else the one that keeps most.
  double at_goal = 0;
  Joints best{};
  bool reachable = false;
  const auto keeps_all = [&](const Joints& q) {
    reachable = true;
    const double kept = kept_margin(keeps_clear, q);
    if (kept > at_goal) {
      at_goal = kept;
      best = q;
    }
    return kept == FreeSearch::kMargin;
  };
  const auto goal = goal_of(arm, settings, start, command.target, keeps_all);
  if (!goal && !reachable) return tl::unexpected(goal.error());
  const double margin = std::min(at_start, at_goal);
  if (margin == 0) return refuse("path", "target", "the arm, or what it carries, would touch something at the target");
  const Allowed allowed = [keeps_clear, margin](const Joints& q) { return keeps_clear(q, margin); };
  return FreeSearch{FreePath(arm.limits(), allowed, start, best, seed), *limits};
}

double tool_way(const ArmModel& arm, const Joints& q, const Joints& way) {
  const Jacobian jacobian = arm.jacobian(q);
  Vec3 moved{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kJoints; ++i) moved[axis] += jacobian[axis][i] * way[i];
  }
  return std::hypot(moved[0], moved[1], moved[2]);
}

void keep_tool_speed(const ArmModel& arm, double speed, Trajectory& trajectory) {
  constexpr int kPlaces = 200;
  double fastest = 0;
  for (int place = 0; place <= kPlaces; ++place) {
    const Reference reference = trajectory.at(trajectory.duration() * place / kPlaces);
    fastest = std::max(fastest, tool_way(arm, reference.q, reference.dq));
  }
  if (fastest > speed) trajectory.stretch(fastest / speed);
}

}  // namespace race::robot
