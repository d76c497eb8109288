// GET /api/v1/cores/{id}/journal: header and inputs of the run.
#include "server/execution/cores.h"
#include "server/handlers/runs.h"
#include "server/runs/run_file.h"

namespace race::server {

Handled get_core_journal(const Request& request, Cores& cores, Runs& runs) {
  const auto core = core_of(request, cores);
  if (!core) return tl::unexpected(core.error());
  const auto journal = journal_of(**core, runs);
  if (!journal) return failed(journal.error());
  return answer_text(bounded_text(journal_json(*journal)));
}

}  // namespace race::server
