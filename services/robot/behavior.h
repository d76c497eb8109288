// Behavior: how the robot acts while it follows a command, and how it reacts by itself (thesis 2.5: an
// action is a tuple of command and behavior, a behavior is operational and reflex behavior). Values, no functions of
// time. As tasks write it: behavior_value.h.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "services/robot/arm_model.h"

namespace race::robot {

enum class Mode {
  position,              // follows its reference stiffly (computed torque)
  joint_impedance,       // springs and dampers at the joints
  cartesian_impedance,   // springs and dampers at the tool centre point, along the axes of o
  gravity_compensation,  // carries its own weight and can be led by hand
};

struct Operational {
  Mode mode = Mode::position;
  Joints joint_stiffness{600, 600, 400, 400, 200, 100, 100};              // Nm/rad
  std::array<double, 6> tool_stiffness{1000, 1000, 1000, 100, 100, 100};  // N/m, Nm/rad
  double damping = 0.8;                                                   // ratio, 1: critical; both impedances
  std::optional<double> speed;  // m/s, of the tool centre point during a motion
  std::optional<double> force;  // N, that the spring at the tool pulls with at most; Cartesian impedance
  bool operator==(const Operational&) const = default;
};

enum class Signal { contact, collision, force_limit, virtual_wall, joint_limit };
enum class Severity { light, medium, severe };
enum class Reaction { stop, gravity_compensation, retreat, slow_down };

/// The tool centre point must not get behind it. `normal` (unit) points to the allowed side.
struct Plane {
  Vec3 point{}, normal{};
  bool operator==(const Plane&) const = default;
};
/// The tool centre point must not get into it; edges along o.
struct Box {
  Vec3 min{}, max{};
  bool operator==(const Box&) const = default;
};
using Wall = std::variant<Plane, Box>;

struct Reflex {
  Signal signal = Signal::collision;
  Reaction reaction = Reaction::stop;
  Severity severity = Severity::light;  // collision: from which severity on
  double force = 0;                     // N, force_limit
  Wall wall = {};                       // virtual_wall
  double margin = 0.05;                 // rad before a limit, joint_limit
  double distance = 0.05;               // m of the tool back along the path, retreat
  double scale = 0.2;                   // of the speed, slow_down
  bool operator==(const Reflex&) const = default;
};

struct Behavior {
  Operational operational;
  std::vector<Reflex> reflexes;
  bool operator==(const Behavior&) const = default;
};

/// A behavior of `mode` with its usual stiffness and reflexes: a collision stops it, but for gravity compensation,
/// where the hand that leads the arm must not.
Behavior usual_behavior(Mode mode);

/// The behavior of an arm that has to hold by position without a behavior given for it. A behavior of `position` stays
/// as it is; of another mode stays what limits, its speed and its reflexes, but for those on collisions: they were
/// meant for an arm that gives way, and those of usual_behavior(Mode::position) take their place.
Behavior held_by_position(const Behavior& behavior);

/// The behavior of an arm that a hand leads while a button is held, instead of `behavior`: gravity compensation. Of the
/// reflexes remain those on places, walls and joint limits: what the hand exerts is no collision.
Behavior guided(const Behavior& behavior);

std::string_view name(Mode mode);
std::string_view name(Signal signal);
std::string_view name(Severity severity);
std::string_view name(Reaction reaction);

/// How far `point` is inside the wall's forbidden side, m; negative outside.
double depth(const Wall& wall, const Vec3& point);

}  // namespace race::robot
