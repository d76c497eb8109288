// GET /api/v1/cores/{id}/why?port=&step=&micro=: why a port does not fire now, or why it fired in a past micro step.
#include <limits>

#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"

namespace race::server {

void get_why(const Request& request, Respond respond, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  const std::string port = query_text(request, "port");
  if (port.empty()) return respond(failed({ErrorCode::missing, "which port? ?port=Root/A.success", "port"}));
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  const auto step = query_number(request, "step", {1, kMost}), micro = query_number(request, "micro", {0, kMost});
  if (!step) return respond(failed(step.error()));
  if (!micro) return respond(failed(micro.error()));
  if (!*step && !*micro) return (*core)->why(port, answer_to(std::move(respond)));
  if (!*step || !*micro)
    return respond(failed({ErrorCode::missing, "`step` and `micro` go together", *step ? "micro" : "step"}));
  (*core)->why_before(port, static_cast<std::size_t>(**step), static_cast<int>(**micro), request.gone,
                      answer_to(std::move(respond)));
}

}  // namespace race::server
