#include "server/handlers/goals.h"

namespace race::server {

using execution::Goal;

execution::GoalName read_goal_name(Fields& fields) {
  execution::GoalName goal;
  goal.id = fields.text("id");
  const auto path = fields.text("path");
  if (fields.is_object() && goal.id.has_value() == path.has_value())
    fields.violation(ErrorCode::missing, "exactly one of `id` and `path` must say where", "path");
  goal.path = path.value_or("");
  const auto when = fields.text("when", Fields::Need::required);
  if (when == "entered")
    goal.kind = Goal::Kind::entered;
  else if (when == "left")
    goal.kind = Goal::Kind::left;
  else if (when == "fired")
    goal.kind = Goal::Kind::fired;
  else if (when)
    fields.violation(ErrorCode::type, "`when` must be `entered`, `left` or `fired`", "when");
  return goal;
}

}  // namespace race::server
