// GET /api/v1/cores/{id}/why?port=&step=&micro=: why a port does not fire now, or why it fired in a past micro step.
#include <limits>

#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"

namespace race::server {

Handled get_why(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  const std::string port = query_text(request, "port");
  if (port.empty()) return failed({ErrorCode::missing, "which port? ?port=Root/A.success", "port"});
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  const auto step = query_number(request, "step", {1, kMost}), micro = query_number(request, "micro", {0, kMost});
  if (!step) return failed(step.error());
  if (!micro) return failed(micro.error());
  if (!*step && !*micro) return answer((*core)->why(port));
  if (!*step || !*micro)
    return failed({ErrorCode::missing, "`step` and `micro` go together", *step ? "micro" : "step"});
  return answer((*core)->why_before(port, static_cast<std::size_t>(**step), static_cast<int>(**micro)));
}

}  // namespace race::server
