// GET /api/v1/runs/{run}/derivations?from&to: recomputed from the journal.
#include "server/handlers/runs.h"
#include "server/runs/run_replay.h"

namespace race::server {

Handled get_run_derivations(const Request& request, Runs& runs) {
  const auto from = query_number(request, "from", 1, 0), to = query_number(request, "to", 1, 0);
  if (!from) return failed(from.error());
  if (!to) return failed(to.error());
  return answer(run_derivations(runs, run_number(request.parameters.at("run")), *from, *to));
}

}  // namespace race::server
