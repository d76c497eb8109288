// GET /api/v1/cores/{id}/derivations?from&to: recomputed from the journal.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"

namespace race::server {

void get_derivations(const Request& request, Respond respond, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  const auto from = query_number(request, "from"), to = query_number(request, "to");
  if (!from) return respond(failed(from.error()));
  if (!to) return respond(failed(to.error()));
  (*core)->derivations(static_cast<std::size_t>(from->value_or(0)), static_cast<std::size_t>(to->value_or(0)),
                       request.gone, answer_to(std::move(respond)));
}

}  // namespace race::server
