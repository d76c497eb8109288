// Goals as clients write and read them: the breakpoint of api/schemas/breakpoints.json.
#pragma once

#include "core/execution/goal.h"
#include "core/value/fields.h"

namespace race::server {

/// The longest condition of a goal [characters]: every delta of a core has its breakpoints.
inline constexpr std::size_t kLongestCondition = 500;

/// The fields of a breakpoint. Violations go to the errors of `fields`.
execution::GoalName read_goal_name(Fields& fields);

/// As it was read.
Value goal_json(const execution::GoalName& goal);

}  // namespace race::server
