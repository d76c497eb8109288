// GET /api/v1/cell/{file}: a URDF file that the scene names.
#include "server/cell/cell.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_cell_file(const Request& request, Cell& cell) {
  const auto world = world_of(cell);
  if (!world) return tl::unexpected(world.error());
  auto text = (*world)->file(request.parameters.at("file"));
  if (!text) return failed(std::move(text).error());
  Reply reply;
  reply.text = std::move(*text);
  reply.type = "application/xml";
  return reply;
}

}  // namespace race::server
