// PUT /api/v1/cores/{id}/breakpoints: where the core is paused, in place of what the same person has set before.
#include "server/execution/cores.h"
#include "server/execution/goal_json.h"
#include "server/handlers/breakpoint_list.h"
#include "server/handlers/document_requests.h"
#include "server/store/document_breakpoints.h"

namespace race::server {

void set_breakpoints(const Request& request, Respond respond, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  auto goals = read_breakpoint_list(request.body, read_goal_name);
  if (!goals) return respond(tl::unexpected(std::move(goals).error()));
  auto author = author_of(request);
  if (!author) return respond(failed(std::move(author).error()));
  if (request.query.contains("author"))
    if (auto fits = DocumentBreakpoints::check_author(*author); !fits) return respond(failed(std::move(fits).error()));
  (*core)->set_breakpoints(std::move(*goals), std::move(*author), answer_to(std::move(respond)));
}

}  // namespace race::server
