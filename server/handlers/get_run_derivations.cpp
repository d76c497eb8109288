// GET /api/v1/runs/{run}/derivations?from&to: recomputed from the journal.
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/run_replay.h"

namespace race::server {

Handled get_run_derivations(const Request& request, Runs& runs, Worker& replays) {
  const auto from = query_number(request, "from"), to = query_number(request, "to");
  if (!from) return failed(from.error());
  if (!to) return failed(to.error());
  return answer_replay(replays, [&runs, run = run_number(request.parameters.at("run")),
                                 from = static_cast<std::uint64_t>(from->value_or(0)),
                                 to = static_cast<std::uint64_t>(to->value_or(0))](const Worker::Stop& stop) {
    return run_derivations(runs, run, from, to, &stop);
  });
}

}  // namespace race::server
