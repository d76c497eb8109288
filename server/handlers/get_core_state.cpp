// GET /api/v1/cores/{id}/state.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

void get_core_state(const Request& request, Respond respond, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  (*core)->state(answer_to(std::move(respond)));
}

}  // namespace race::server
