// GET /api/v1/services: RSM, state, pending calls and violations of every service.
#include "server/handlers/handlers.h"

namespace race::server {

Handled list_services(const Request&, Application& app) { return ok(app.services_json()); }

}  // namespace race::server
