#include "server/handlers/goals.h"

namespace race::server {

using execution::Goal;

execution::GoalName read_goal_name(Fields& fields) {
  execution::GoalName goal;
  goal.id = fields.text("id").value_or("");
  goal.path = fields.text("path").value_or("");
  if (fields.is_object() && goal.id.empty() == goal.path.empty())
    fields.violation(ErrorCode::missing, "exactly one of `id` and `path` must say where", "path");
  const std::string when = fields.text("when", Fields::Need::required).value_or("");
  goal.kind = when == "left" ? Goal::Kind::left : when == "fired" ? Goal::Kind::fired : Goal::Kind::entered;
  if (!when.empty() && when != execution::name(goal.kind))
    fields.violation(ErrorCode::type, "`when` must be `entered`, `left` or `fired`", "when");
  return goal;
}

}  // namespace race::server
