// GET /api/v1/cores/{id}/why?port=: why a port fired, or does not fire.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_why(const Request& request, Application& app) {
  const auto core = core_of(request, app);
  if (!core) return tl::unexpected(core.error());
  const auto port = request.query.find("port");
  if (port == request.query.end()) return failed({ErrorCode::missing, "which port? ?port=Root/A.success", "port"});
  return answer((*core)->why(port->second));
}

}  // namespace race::server
