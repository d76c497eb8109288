// Goals as requests name them, for step_core and set_breakpoints.
#pragma once

#include "core/execution/goal.h"
#include "core/value/fields.h"

namespace race::server {

/// The fields `when` (entered, left, fired) and `id` or `path` (api/schemas/breakpoints.json). Violations go to the
/// errors of `fields`.
execution::GoalName read_goal_name(Fields& fields);

}  // namespace race::server
