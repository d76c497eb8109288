// What the robot's operations and events look like as values (README.md has them in words).
#pragma once

#include "core/value/value.h"
#include "services/robot/control_unit.h"

namespace race::robot {

struct Action {
  MoveCommand command;
  std::optional<Behavior> behavior;
  std::optional<Vec3> carried;  // m, edges of the box around the part that the jaws hold; free paths only
};

/// Command and behavior from the bound arguments of `move`. Refusals: `type` (no target of any kind, or of several; a
/// carried part where no free path is planned), `out_of_range` (a number that is not finite, a part of no or of
/// unlikely size), those of read_behavior().
tl::expected<Action, Refusal> read_move(const Dict& arguments);

/// The velocity from the bound arguments of `jog`. Refusals: `type` (neither joint speeds nor a velocity of the tool,
/// or both).
tl::expected<JogVelocity, Refusal> read_jog(const Dict& arguments);

Value to_value(const Pose& pose);
Value to_value(const Joints& joints);
/// Data of the event `robot_state`.
Value to_value(const RobotState& state);
/// Data of the event of an incident, which has its signal's name.
Value to_value(const Incident& incident, const ControlUnit& unit);
/// Header of a packet of the flow `control`. `collision`: the last one, as its event had it, and its time; null: none.
Value control_value(const ControlUnit& unit, const Value& collision);
/// An error response: `code`, `message` and, where there is one, `argument`
/// and `reaction`.
Value to_value(const Refusal& refusal);

}  // namespace race::robot
