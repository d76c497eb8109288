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
  for (const Goal::Kind kind : {Goal::Kind::entered, Goal::Kind::left, Goal::Kind::fired}) {
    if (when != name(kind)) continue;
    goal.kind = kind;
    return goal;
  }
  if (when) fields.violation(ErrorCode::type, "`when` must be `entered`, `left` or `fired`", "when");
  return goal;
}

}  // namespace race::server
