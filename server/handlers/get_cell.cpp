// GET /api/v1/cell: what the cell looks like.
#include "server/cell/cell.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_cell(const Request&, Cell& cell) {
  const auto world = world_of(cell);
  if (!world) return tl::unexpected(world.error());
  return answer((*world)->scene());
}

}  // namespace race::server
