// GET /api/v1/cores/{id}.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_core(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  return ok((*core)->info());
}

}  // namespace race::server
