// GET and PUT /api/v1/documents/{name}/breakpoints: the breakpoints that a person keeps at a document.
#include "server/store/document_breakpoints.h"

#include <tuple>

#include "core/rcm/ids.h"
#include "server/execution/goal_json.h"
#include "server/handlers/breakpoint_list.h"
#include "server/handlers/document_requests.h"

namespace race::server {

namespace {

constexpr std::size_t kLongestPath = 1000, kLongestName = 100;  // bytes

/// One breakpoint, as it is kept.
Value read_kept(Fields& fields) {
  const execution::GoalName goal = read_goal_name(fields);
  const auto enabled = fields.boolean("enabled");
  if (fields.is_object() && !fields.find("enabled"))
    fields.violation(ErrorCode::missing, "the field `enabled` is missing", "enabled");
  if (goal.id && !rcm::is_id(*goal.id)) fields.violation(ErrorCode::name, "an id is 1 to 64 of A-Z a-z 0-9 _ -", "id");
  for (const auto& [key, text, most] :
       {std::tuple{"path", goal.path, kLongestPath}, std::tuple{"service", goal.service, kLongestName},
        std::tuple{"operation", goal.operation, kLongestName}})
    if (text.size() > most)
      fields.violation(ErrorCode::too_large, "may have " + std::to_string(most) + " characters", key);
  Dict kept = goal_json(goal).as_dict();
  kept.set("enabled", enabled.value_or(true));
  return kept;
}

}  // namespace

Handled get_document_breakpoints(const Request& request, DocumentBreakpoints& breakpoints) {
  const auto author = author_of(request);
  if (!author) return failed(author.error());
  auto found = breakpoints.get(request.parameters.at("name"), *author);
  if (!found) return failed(std::move(found).error());
  return ok(Dict{{"breakpoints", std::move(*found)}});
}

Handled put_document_breakpoints(const Request& request, DocumentBreakpoints& breakpoints) {
  auto read = read_breakpoint_list(request.body, read_kept);
  if (!read) return tl::unexpected(std::move(read).error());
  const auto author = author_of(request);
  if (!author) return failed(author.error());
  auto set = breakpoints.set(request.parameters.at("name"), *author, *read);
  if (!set) return failed(std::move(set).error());
  return ok(Dict{{"breakpoints", std::move(*read)}});
}

}  // namespace race::server
