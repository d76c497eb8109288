// POST /api/v1/cores/{id}/pause, resume, stop.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Handled command(const Request& request, Cores& cores, Expected<Value> (Core::*what)()) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  return answer(((**core).*what)());
}

}  // namespace

Handled pause_core(const Request& request, Cores& cores) { return command(request, cores, &Core::pause); }
Handled resume_core(const Request& request, Cores& cores) { return command(request, cores, &Core::resume); }
Handled stop_core(const Request& request, Cores& cores) { return command(request, cores, &Core::stop); }

}  // namespace race::server
