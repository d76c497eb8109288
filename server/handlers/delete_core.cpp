// DELETE /api/v1/cores/{id}: a run is stopped first.
#include "server/handlers/handlers.h"

namespace race::server {

Handled delete_core(const Request& request, Application& app) {
  auto core = app.cores().remove(request.parameters.at("id"));
  if (!core) return failed(std::move(core).error());
  // One that is over or was never started has nothing to stop.
  const auto stopped = (*core)->stop();
  if (!stopped && stopped.error().code != ErrorCode::conflict)
    app.log("core/" + (*core)->id(), to_string(stopped.error()));
  (*core)->close();
  app.core_removed((*core)->id());
  return ok((*core)->info());
}

}  // namespace race::server
