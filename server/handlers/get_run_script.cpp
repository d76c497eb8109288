// GET /api/v1/runs/{run}/script: the run as a script for race derive.
#include "server/handlers/runs.h"
#include "server/runs/run_file.h"

namespace race::server {

Handled get_run_script(const Request& request, Runs& runs) {
  const auto run = run_of(request, runs);
  if (!run) return failed(run.error());
  const auto journal = journal_of(*run, runs);
  if (!journal) return failed(journal.error());
  return answer_text(bounded_text(script_json(*journal)));
}

}  // namespace race::server
