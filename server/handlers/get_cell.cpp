// GET /api/v1/cell: what the cell looks like, and whether it is stopped.
#include "server/cell/cell.h"
#include "server/control/control.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_cell(const Request&, Cell& cell, Control& control) {
  const auto world = world_of(cell);
  if (!world) return tl::unexpected(world.error());
  auto scene = (*world)->scene();
  if (!scene) return failed(std::move(scene).error());
  Dict json = scene->as_dict();
  json.set("stopped", control.stopped().has_value());
  return ok(std::move(json));
}

}  // namespace race::server
