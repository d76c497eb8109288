// GET /api/v1/runs/{run}/derivations?from&to: recomputed from the journal.
#include "server/handlers/runs.h"
#include "server/runs/run_replay.h"

namespace race::server {

Handled get_run_derivations(const Request& request, Runs& runs, Worker& replays) {
  const auto from = query_number(request, "from", 1, 0), to = query_number(request, "to", 1, 0);
  if (!from) return failed(from.error());
  if (!to) return failed(to.error());
  return answer_replay(replays, [&runs, run = run_number(request.parameters.at("run")), from = *from, to = *to](
                                    const Worker::Stop& stop) { return run_derivations(runs, run, from, to, &stop); });
}

}  // namespace race::server
