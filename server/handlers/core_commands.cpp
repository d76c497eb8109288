// POST /api/v1/cores/{id}/start, pause, resume, stop.
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Handled command(const Request& request, Application& app, Expected<Value> (Core::*what)()) {
  const auto core = core_of(request, app);
  if (!core) return tl::unexpected(core.error());
  return answer(((**core).*what)());
}

}  // namespace

Handled start_core(const Request& request, Application& app) { return command(request, app, &Core::start); }
Handled pause_core(const Request& request, Application& app) { return command(request, app, &Core::pause); }
Handled resume_core(const Request& request, Application& app) { return command(request, app, &Core::resume); }
Handled stop_core(const Request& request, Application& app) { return command(request, app, &Core::stop); }

}  // namespace race::server
