// GET /api/v1/services: RSM, state, pending calls and violations of every service.
#include "server/cell/cell.h"
#include "server/handlers/handlers.h"
#include "server/wire/service_json.h"

namespace race::server {

Handled list_services(const Request&, Cell& cell) { return ok(services_json(cell.host().services())); }

}  // namespace race::server
