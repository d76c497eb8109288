// POST /api/v1/cores: a core of a document and arguments, which waits to be started.
#include "server/execution/live_edits.h"
#include "server/handlers/core_model.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled create_core(const Request& request, Documents& documents, Cores& cores, LiveEdits& edits) {
  auto model = read_core_model(request, documents);
  if (!model) return tl::unexpected(std::move(model).error());
  const bool live = model->live.value_or(false);
  const auto core = cores.create(model->document, std::move(model->arguments), live);
  if (!core) return tl::unexpected(core.error());
  if (live) edits.changed(model->document.name);  // there may be a later revision
  return created((*core)->info(), "/api/v1/cores/" + (*core)->id());
}

}  // namespace race::server
