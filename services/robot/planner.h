// From a wish to move to a trajectory, or to the reason why not. Nothing moves here.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <variant>

#include "services/robot/arm_model.h"
#include "services/robot/trajectory.h"

namespace race::robot {

/// Why a motion is refused or has failed, as its caller gets it.
struct Refusal {
  std::string code;      // what a program branches on
  std::string argument;  // of the operation, empty if none is to blame
  std::string message;
};

/// A way of the tool centre point, in o, from where it is.
struct Offset {
  Vec3 metres{};
};

using Target = std::variant<Joints, Pose, Offset>;

enum class MotionKind {
  point_to_point,  // straight in joint space
  linear,          // the tool centre point on a straight line, turning evenly
};

struct MoveCommand {
  Target target;
  MotionKind kind = MotionKind::point_to_point;
  double speed = 0.5;         // share of the speed limits, (0, 1]
  double acceleration = 0.5;  // share of the acceleration limits, (0, 1]
};

/// Limits at speed = acceleration = 1, besides those of the arm's model.
struct PlannerSettings {
  Joints acceleration{};            // rad/s2
  Joints preferred{};               // rad, posture that redundancy is resolved towards
  double tool_speed = 0;            // m/s, linear motions
  double tool_acceleration = 0;     // m/s2
  double tool_turning = 0;          // rad/s
  double turning_acceleration = 0;  // rad/s2
};

/// Plans from `start`, standing. Codes: `out_of_range` (a share outside of (0, 1], a quaternion that is none, a number
/// that is not finite), `joint_limits` (a joint target outside of them), `unreachable` (no joint positions for the
/// target pose), `path` (a linear path that leaves the reach or would turn a joint by a jump).
tl::expected<Trajectory, Refusal> plan(const ArmModel& arm, const PlannerSettings& settings, const Joints& start,
                                       const MoveCommand& command);

}  // namespace race::robot
