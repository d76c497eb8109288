#include "server/execution/goal_json.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace race::server {

using execution::Goal;
using execution::GoalName;
using Kind = Goal::Kind;

namespace {

constexpr std::array kKinds = {Kind::entered,  Kind::left,   Kind::into,  Kind::fired,    Kind::tested,
                               Kind::executed, Kind::called, Kind::fault, Kind::fulfilled};

std::optional<Kind> kind_of(std::string_view when) {
  const auto kind = std::ranges::find_if(kKinds, [&](Kind each) { return name(each) == when; });
  return kind == kKinds.end() ? std::nullopt : std::optional(*kind);
}

std::string kind_names() {
  std::string names;
  for (const Kind each : kKinds) names += (names.empty() ? "`" : ", `") + std::string(name(each)) + "`";
  return names;
}

// Calls and faults are those of the whole task if nothing says where.
void read_kind_and_place(Fields& fields, GoalName& goal) {
  goal.id = fields.text("id");
  const auto path = fields.text("path");
  goal.path = path.value_or("");
  const auto when = fields.text("when", Fields::Need::required);
  const auto kind = kind_of(when.value_or(""));
  const bool is_optional = kind == Kind::called || kind == Kind::fault;
  if (fields.is_object() && goal.id && path)
    fields.violation(ErrorCode::type, "one of `id` and `path` says where, not both", "path");
  if (fields.is_object() && !goal.id && !path && !is_optional)
    fields.violation(ErrorCode::missing, "exactly one of `id` and `path` must say where", "path");
  if (when && !kind) fields.violation(ErrorCode::type, "`when` must be one of " + kind_names(), "when");
  goal.kind = kind.value_or(Kind::entered);
}

void read_operation(Fields& fields, GoalName& goal) {
  for (const auto& [key, text] : {std::pair{"service", &goal.service}, std::pair{"operation", &goal.operation}}) {
    const auto found = fields.text(key);
    if (found && goal.kind != Kind::called)
      fields.violation(ErrorCode::type, "only `called` is about an operation", key);
    *text = found.value_or("");
  }
}

}  // namespace

GoalName read_goal_name(Fields& fields) {
  GoalName goal;
  read_kind_and_place(fields, goal);
  read_operation(fields, goal);
  goal.before = fields.boolean("before").value_or(false);
  goal.condition = fields.text("condition").value_or("");
  if (goal.kind == Kind::fulfilled && goal.condition.empty())
    fields.violation(ErrorCode::missing, "`condition` must say what is to become fulfilled", "condition");
  if (goal.condition.size() > kLongestCondition)
    fields.violation(ErrorCode::too_large, "a condition may have " + std::to_string(kLongestCondition) + " characters",
                     "condition");
  return goal;
}

Value goal_json(const GoalName& goal) {
  Dict json{{"when", execution::name(goal.kind)}};
  if (goal.id)
    json.set("id", *goal.id);
  else if (!goal.path.empty())
    json.set("path", goal.path);
  if (goal.before) json.set("before", true);
  for (const auto& [key, text] : {std::pair{"service", &goal.service}, std::pair{"operation", &goal.operation},
                                  std::pair{"condition", &goal.condition}})
    if (!text->empty()) json.set(key, *text);
  return json;
}

}  // namespace race::server
