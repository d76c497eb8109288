// GET /api/v1/cores/{id}/past?step=&micro= and /api/v1/runs/{run}/past: a run as it was, recomputed from its journal.
#include <limits>
#include <optional>

#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/run_replay.h"

namespace race::server {

namespace {

struct AskedMoment {
  std::uint64_t step;
  int micro;
};

/// The query's `step` and, if it is there, `micro`; else the end of the macro step.
Expected<AskedMoment> moment_of(const Request& request) {
  constexpr int kEnd = std::numeric_limits<int>::max();
  ASSIGN_OR_RETURN(const std::optional<std::int64_t> step, query_number(request, "step", {1, kEnd}));
  ASSIGN_OR_RETURN(const std::optional<std::int64_t> micro, query_number(request, "micro", {0, kEnd}));
  if (!step) return unexpected(ErrorCode::missing, "which macro step? ?step=7", "step");
  return AskedMoment{static_cast<std::uint64_t>(*step), static_cast<int>(micro.value_or(kEnd))};
}

}  // namespace

void get_past(const Request& request, Respond respond, Cores& cores) {
  const auto core = core_of(request, cores);
  if (!core) return respond(tl::unexpected(core.error()));
  const auto moment = moment_of(request);
  if (!moment) return respond(failed(moment.error()));
  (*core)->past(moment->step, moment->micro, request.gone, answer_to(std::move(respond)));
}

void get_run_past(const Request& request, Respond respond, Runs& runs, Worker& replays) {
  const auto moment = moment_of(request);
  if (!moment) return respond(failed(moment.error()));
  answer_replay(request, std::move(respond), replays,
                [&runs, run = run_number(request.parameters.at("run")), moment = *moment](const Stop& stop) {
                  return run_past(runs, run, moment.step, moment.micro, &stop);
                });
}

}  // namespace race::server
