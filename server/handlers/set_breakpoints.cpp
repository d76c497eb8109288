// PUT /api/v1/cores/{id}/breakpoints: where the core is paused, in place of what was set before.
#include "core/value/json.h"
#include "server/execution/cores.h"
#include "server/execution/goal_json.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Checked<std::vector<execution::GoalName>> read_breakpoints(const std::string& text) {
  auto body = parse_json(text);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const List& list = fields.list("breakpoints", Fields::Need::required);
  fields.close();
  std::vector<execution::GoalName> goals;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Fields of_one(list[i], "breakpoints/" + std::to_string(i), "a breakpoint", errors, Fields::Paths::field);
    goals.push_back(read_goal_name(of_one));
    of_one.close();
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return goals;
}

}  // namespace

void set_breakpoints(const Request& request, Respond respond, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  auto goals = read_breakpoints(request.body);
  if (!goals) return respond(tl::unexpected(std::move(goals).error()));
  (*core)->set_breakpoints(std::move(*goals), answer_to(std::move(respond)));
}

}  // namespace race::server
