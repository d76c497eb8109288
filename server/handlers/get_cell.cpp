// GET /api/v1/cell: what the cell looks like.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_cell(const Request&, Application& app) {
  const auto world = world_of(app);
  if (!world) return tl::unexpected(world.error());
  return answer((*world)->scene());
}

}  // namespace race::server
