// POST /api/v1/cores/{id}/force: sets a value, or takes a port of an active state (core/SEMANTICS.md section 9).
#include "core/execution/input_fields.h"
#include "server/execution/cores.h"
#include "server/handlers/body.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"

namespace race::server {

void force_core(const Request& request, Respond respond, Cores& cores, ManualControl& manual) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  auto force = read_body(request.body, execution::read_force);
  if (!force) return respond(tl::unexpected(std::move(force).error()));
  const auto control = control_of(request, manual);
  if (!control) return respond(failed(control.error()));
  (*core)->force(std::move(*force), answer_to(std::move(respond)), *control);
}

}  // namespace race::server
