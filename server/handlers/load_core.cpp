// POST /api/v1/cores/{id}/load: another document, its last revision, or other arguments in a core that has not begun.
#include "server/execution/live_edits.h"
#include "server/handlers/core_model.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled load_core(const Request& request, Documents& documents, Cores& cores, LiveEdits& edits) {
  auto model = read_core_model(request, documents);
  if (!model) return tl::unexpected(std::move(model).error());
  const auto core = cores.load(request.parameters.at("id"), model->document, std::move(model->arguments));
  if (!core) return tl::unexpected(core.error());
  return answer(follow_document(**core, *model, edits));
}

}  // namespace race::server
