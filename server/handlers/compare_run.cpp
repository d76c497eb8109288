// GET /api/v1/runs/{run}/compare?with&from: where two runs first do different things.
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/run_replay.h"

namespace race::server {

void compare_run(const Request& request, Respond respond, Runs& runs, Worker& replays) {
  const auto with = request.query.find("with");
  if (with == request.query.end()) return respond(failed({ErrorCode::missing, "with which run? ?with=2", "with"}));
  const auto from = query_number(request, "from");
  if (!from) return respond(failed(from.error()));
  answer_replay(request, std::move(respond), replays,
                [&runs, first = run_number(request.parameters.at("run")), second = run_number(with->second),
                 from = static_cast<std::uint64_t>(from->value_or(1))](const Stop& stop) {
                  return compare_runs(runs, first, second, from, kMostCompared, &stop);
                });
}

}  // namespace race::server
