// GET /api/v1/cores.
#include "server/handlers/handlers.h"

namespace race::server {

Handled list_cores(const Request&, Application& app) { return ok(app.cores_json()); }

}  // namespace race::server
