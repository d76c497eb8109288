// GET /api/v1/runs/{run}/samples: where everything in the cell was while the run was running.
#include "server/handlers/runs.h"
#include "server/runs/run_json.h"
#include "server/store/samples.h"

namespace race::server {

Handled get_run_samples(const Request& request, Runs& runs, Samples& samples) {
  const auto run = run_of(request, runs);
  if (!run) return failed(run.error());
  const auto found = samples.read(run->id);
  if (!found) return failed(found.error());
  return ok(Dict{{"samples", samples_json(*found)}});
}

}  // namespace race::server
