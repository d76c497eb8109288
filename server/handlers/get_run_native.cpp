// GET /api/v1/runs/{run}/native: the model that was executed.
#include "server/handlers/runs.h"

namespace race::server {

Handled get_run_native(const Request& request, Runs& runs) {
  const auto header = runs.header(run_number(request.parameters.at("run")));
  if (!header) return failed(header.error());
  return ok(header->native);
}

}  // namespace race::server
