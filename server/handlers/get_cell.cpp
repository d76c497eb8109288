// GET /api/v1/cell: what the cell looks like.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_cell(const Request&, Application& app) {
  if (!app.cell().has_world()) return failed({ErrorCode::not_found, "this server has no cell"});
  return ok(app.cell().scene());
}

}  // namespace race::server
