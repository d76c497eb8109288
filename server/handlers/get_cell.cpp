// GET /api/v1/cell: what the cell looks like.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_cell(const Request&, Application& app) {
  if (!app.cell().has_world())
    return failed({ErrorCode::not_found,
                   "there is no world here: the server has no cell, or the cell is in a process of its own"});
  return ok(app.cell().scene());
}

}  // namespace race::server
