// GET /api/v1/cores/{id}/derivations?from&to: recomputed from the journal.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"

namespace race::server {

Handled get_derivations(const Request& request, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  const auto from = query_number(request, "from"), to = query_number(request, "to");
  if (!from) return failed(from.error());
  if (!to) return failed(to.error());
  return answer(
      (*core)->derivations(static_cast<std::size_t>(from->value_or(0)), static_cast<std::size_t>(to->value_or(0))));
}

}  // namespace race::server
