// Jogging: manual motion with a wanted velocity, of the joints or of the tool, that may change in every control cycle.
// It gives the reference that the arm follows: joint speeds change with bounded acceleration, slow down before joint
// limits, and none races near a singularity. What a velocity is wanted for, and how long it is good, the control unit
// knows.
#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <variant>

#include "services/robot/arm_model.h"
#include "services/robot/planner.h"
#include "services/robot/trajectory.h"

namespace race::robot {

/// Velocity of the tool centre point.
struct ToolVelocity {
  enum class Axes { o, tool };
  Vec3 linear{};   // m/s
  Vec3 angular{};  // rad/s
  Axes axes = Axes::o;
};

/// What a person wants: rad/s of each joint, or a velocity of the tool.
using JogVelocity = std::variant<Joints, ToolVelocity>;

/// Of manual motion.
struct JogLimits {
  static constexpr double kLinear = 0.25;  // m/s
  static constexpr double kAngular = 1.0;  // rad/s
  Joints velocity{};                       // rad/s
  Joints acceleration{};                   // rad/s2, speeding up
  Joints braking{};                        // rad/s2, slowing down
};

/// Half of the joints' speed limits and of `acceleration`, all of `braking` [rad/s2].
JogLimits jog_limits(const ArmModel& arm, const Joints& acceleration, const Joints& braking);

/// Refusal `out_of_range`: a number that is not finite, a joint above its speed, a tool above kLinear or kAngular.
tl::expected<void, Refusal> check_jog(const JogVelocity& wanted, const JogLimits& limits);

class Jogging {
 public:
  /// Kept before each joint limit, rad.
  static constexpr double kMargin = 0.01;

  /// Begins at `from`, which may move. `arm` outlives it.
  Jogging(const ArmModel& arm, const JogLimits& limits, const Reference& from)
      : arm_(arm), limits_(limits), reference_(from) {}

  /// Requires what passes check_jog().
  void set_velocity(const JogVelocity& wanted) { wanted_ = wanted; }

  /// The reference of the next cycle of `dt` seconds, on the way to `share` (0..1) of the wanted velocity; the tool
  /// centre point keeps below `tool_speed` [m/s], if there is one, or slows down to it.
  Reference advance(double share, std::optional<double> tool_speed, double dt);

  /// Where the joints will be at the end of the cycle, rad.
  const Joints& place() const { return reference_.q; }
  /// Whether they will stand then.
  bool standing() const { return reference_.dq == Joints{}; }

 private:
  Joints wanted_joints(double share, std::optional<double> tool_speed, double dt) const;
  void keep_joint_limits(Joints& wanted, double dt) const;
  Joints on_the_way_to(const Joints& wanted, double dt) const;
  double most_towards_limit(std::size_t joint, double dq, double braking, double dt) const;

  const ArmModel& arm_;
  JogLimits limits_;
  Reference reference_;
  JogVelocity wanted_;
};

}  // namespace race::robot
