// POST /api/v1/cores/{id}/step: one micro step, one macro step, or until a state is entered or left or a port fires.
#include "core/value/json.h"
#include "server/execution/cores.h"
#include "server/execution/goal_json.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"

namespace race::server {

namespace {

Checked<execution::GoalName> read_goal(const std::string& text) {
  auto body = parse_json(text);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the step", errors, Fields::Paths::field);
  const std::string kind = fields.text("kind", Fields::Need::required).value_or("");
  execution::GoalName goal;
  if (kind == "until") {
    goal = read_goal_name(fields);
  } else {
    goal.kind = kind == "micro" ? execution::Goal::Kind::micro : execution::Goal::Kind::macro;
    if (kind != "micro" && kind != "macro")
      fields.violation(ErrorCode::type, "`kind` must be `micro`, `macro` or `until`", "kind");
  }
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return goal;
}

}  // namespace

void step_core(const Request& request, Respond respond, Cores& cores, ManualControl& manual) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  auto goal = read_goal(request.body);
  if (!goal) return respond(tl::unexpected(std::move(goal).error()));
  const auto control = control_of(request, manual);
  if (!control) return respond(failed(control.error()));
  (*core)->step(std::move(*goal), answer_to(std::move(respond)), {.control = *control});
}

}  // namespace race::server
