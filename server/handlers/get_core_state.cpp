// GET /api/v1/cores/{id}/state.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_core_state(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  return answer((*core)->state());
}

}  // namespace race::server
