// GET /api/v1/cores.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled list_cores(const Request&, Cores& cores) { return ok(cores_json(cores)); }

}  // namespace race::server
