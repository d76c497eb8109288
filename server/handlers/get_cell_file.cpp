// GET /api/v1/cell/{file}: a URDF file that the scene names.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_cell_file(const Request& request, Application& app) {
  auto text = app.cell().file(request.parameters.at("file"));
  if (!text) return failed({ErrorCode::not_found, "the scene names no such file", request.parameters.at("file")});
  Reply reply;
  reply.text = std::move(*text);
  reply.type = "application/xml";
  return reply;
}

}  // namespace race::server
