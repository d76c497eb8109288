// A behavior as tasks write it: {"operational": {...}, "reflexes": [...]}; README.md has its fields.
#pragma once

#include "core/value/value.h"
#include "services/robot/behavior.h"
#include "services/robot/planner.h"

namespace race::robot {

/// The TYPE of a behavior, as JSON text: for the RSM.
extern const char* const kBehaviorType;

/// The behavior of a value; a string that names a mode stands for the usual behavior of that mode. What is absent is
/// as in usual_behavior(). Refusals, all with the argument `behavior` and the field in the message: `type` (not of
/// kBehaviorType, a list of another size, a field that is not for this mode, signal or reaction), `missing`,
/// `out_of_range`, `duplicate` (two reflexes on the same signal, which are not on different severities or walls).
tl::expected<Behavior, Refusal> read_behavior(const Value& value);

}  // namespace race::robot
