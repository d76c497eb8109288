// DELETE /api/v1/cores/{id}: a run is stopped first.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled delete_core(const Request& request, Cores& cores) {
  const auto core = cores.remove(request.parameters.at("id"));
  if (!core) return failed(core.error());
  return ok((*core)->info());
}

}  // namespace race::server
