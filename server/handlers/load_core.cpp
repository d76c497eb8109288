// POST /api/v1/cores/{id}/load: another document, its last revision, or other arguments in a core that has not begun.
#include "server/execution/live_edits.h"
#include "server/handlers/core_model.h"
#include "server/handlers/handlers.h"

namespace race::server {

void load_core(const Request& request, Respond respond, Documents& documents, Cores& cores, LiveEdits& edits) {
  auto model = read_core_model(request, documents);
  if (!model) return respond(tl::unexpected(std::move(model).error()));
  cores.load(request.parameters.at("id"), model->document, std::move(model->arguments), model->live,
             [respond = std::move(respond), &edits,
              document = model->document.name](const Checked<std::shared_ptr<Core>>& core) {
               if (!core) return respond(tl::unexpected(core.error()));
               if ((*core)->is_live()) edits.changed(document);  // there may be a later revision
               respond(ok((*core)->info()));
             });
}

}  // namespace race::server
