// What the robot's operations and events look like as values (README.md has them in words).
#pragma once

#include "core/value/value.h"
#include "services/robot/control_unit.h"

namespace race::robot {

/// A command from the bound arguments of `move`. Refusals: `type` (no target of any kind, or of several),
/// `out_of_range` (a number that is not finite).
tl::expected<MoveCommand, Refusal> read_move(const Dict& arguments);

Value to_value(const Pose& pose);
Value to_value(const Joints& joints);
/// Data of the event `robot_state`.
Value to_value(const RobotState& state);
/// Data of the event `contact`.
Value contact_value(const Contact& contact, const ControlUnit& unit);
/// An error response: `code`, `message` and, if one is to blame, `argument`.
Value to_value(const Refusal& refusal);

}  // namespace race::robot
