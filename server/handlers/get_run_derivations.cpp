// GET /api/v1/runs/{run}/derivations?from&to: recomputed from the journal.
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/run_replay.h"

namespace race::server {

void get_run_derivations(const Request& request, Respond respond, Runs& runs, Worker& replays) {
  const auto from = query_number(request, "from"), to = query_number(request, "to");
  if (!from) return respond(failed(from.error()));
  if (!to) return respond(failed(to.error()));
  answer_replay(
      request, std::move(respond), replays,
      [&runs, run = run_number(request.parameters.at("run")), from = static_cast<std::uint64_t>(from->value_or(0)),
       to = static_cast<std::uint64_t>(to->value_or(0))](const Stop& stop) {
        return run_derivations(runs, run, from, to, &stop);
      });
}

}  // namespace race::server
