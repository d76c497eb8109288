// GET /api/v1/cores/{id}/state.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_core_state(const Request& request, Application& app) {
  const auto core = core_of(request, app);
  if (!core) return tl::unexpected(core.error());
  return answer((*core)->state());
}

}  // namespace race::server
