// GET /api/v1/cores/{id}/native: the model that this core executes.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_core_native(const Request& request, Application& app) {
  const auto core = core_of(request, app);
  if (!core) return tl::unexpected(core.error());
  return ok((*core)->header().native);
}

}  // namespace race::server
