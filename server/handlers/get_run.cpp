// GET /api/v1/runs/{run}: one run as it is listed.
#include "server/handlers/runs.h"
#include "server/runs/run_json.h"

namespace race::server {

Handled get_run(const Request& request, Runs& runs) {
  const auto run = run_of(request, runs);
  if (!run) return failed(run.error());
  return ok(run_json(*run));
}

}  // namespace race::server
