// POST /api/v1/cores/{id}/pause, resume, stop.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

void command(const Request& request, Respond respond, Cores& cores, void (Core::*what)(Done<Value>)) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  ((**core).*what)(answer_to(std::move(respond)));
}

}  // namespace

void pause_core(const Request& request, Respond respond, Cores& cores) {
  command(request, std::move(respond), cores, &Core::pause);
}
void resume_core(const Request& request, Respond respond, Cores& cores) {
  command(request, std::move(respond), cores, &Core::resume);
}
void stop_core(const Request& request, Respond respond, Cores& cores) {
  command(request, std::move(respond), cores, &Core::stop);
}

}  // namespace race::server
