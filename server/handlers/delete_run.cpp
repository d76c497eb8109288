// DELETE /api/v1/runs/{run}: a run that no core hosts, also one that is damaged.
#include "server/execution/cores.h"
#include "server/handlers/runs.h"

namespace race::server {

Handled delete_run(const Request& request, Runs& runs, Cores& cores) {
  const RunId id = run_number(request.parameters.at("run"));
  if (cores.find(std::to_string(id)))
    return failed({ErrorCode::conflict, "a core has this run; delete the core first", std::to_string(id)});
  if (auto removed = runs.remove(id); !removed) return failed(std::move(removed).error());
  return ok(Dict{{"removed", std::to_string(id)}});
}

}  // namespace race::server
