// GET /api/v1/cores/{id}.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_core(const Request& request, Application& app) {
  const auto core = core_of(request, app);
  if (!core) return tl::unexpected(core.error());
  return ok((*core)->info());
}

}  // namespace race::server
