// From a wish to move to a trajectory, or to the reason why not. Nothing moves here.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <variant>

#include "services/robot/arm_model.h"
#include "services/robot/free_path.h"
#include "services/robot/trajectory.h"

namespace race::robot {

/// Why a motion is refused or has failed, as its caller gets it.
struct Refusal {
  std::string code;      // what a program branches on
  std::string argument;  // of the operation, empty if none is to blame
  std::string message;
  std::string reaction = {};  // of the reflex that interrupted a motion, empty if none did
};

/// A way of the tool centre point, in o, from where it is.
struct Offset {
  Vec3 metres{};
};

using Target = std::variant<Joints, Pose, Offset>;

enum class MotionKind {
  point_to_point,  // straight in joint space
  linear,          // the tool centre point on a straight line, turning evenly
  free,            // around what stands in the cell: see FreeSearch
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
/// target pose), `path` (a linear path that leaves the reach or would turn a joint by a jump). Requires another kind
/// than `free`.
tl::expected<Trajectory, Refusal> plan(const ArmModel& arm, const PlannerSettings& settings, const Joints& start,
                                       const MoveCommand& command);

/// Whether the arm at these joint positions keeps this distance [m] from everything that stands in the cell.
using KeepsClear = std::function<bool(const Joints&, double)>;

/// A free path that is being searched, and what it is for.
struct FreeSearch {
  /// Kept from everything, m; less where the start or the goal is nearer, but never nothing.
  static constexpr double kMargin = 0.02;

  FreePath path;
  MotionLimits limits;

  /// Requires that the search has found a path.
  Trajectory trajectory() const { return Trajectory(path.places(), limits); }
};

/// Begins the search of a motion of kind `free`. Codes: those of plan() that are not about lines, and `path` (the arm
/// is in contact with something now, or would be at every posture found for the target).
tl::expected<FreeSearch, Refusal> begin_search(const ArmModel& arm, const PlannerSettings& settings,
                                               const KeepsClear& keeps_clear, const Joints& start,
                                               const MoveCommand& command, unsigned seed);

/// Stretches the time of a trajectory until the tool centre point is nowhere faster than `speed` [m/s, > 0].
void keep_tool_speed(const ArmModel& arm, double speed, Trajectory& trajectory);

/// How far the tool centre point goes, m, when the joints at `q` go a small way.
double tool_way(const ArmModel& arm, const Joints& q, const Joints& way);

}  // namespace race::robot
