// POST /api/v1/cores: a core of a document and arguments, which waits to be started.
#include <tuple>

#include "server/execution/live_edits.h"
#include "server/handlers/core_model.h"
#include "server/handlers/handlers.h"

namespace race::server {

Handled create_core(const Request& request, Documents& documents, Cores& cores, LiveEdits& edits) {
  auto model = read_core_model(request, documents);
  if (!model) return tl::unexpected(std::move(model).error());
  const auto core = cores.create(model->document, std::move(model->arguments));
  if (!core) return tl::unexpected(core.error());
  const auto info = follow_document(**core, *model, edits);
  if (!info) {
    std::ignore = cores.remove((*core)->id());  // whole or not at all
    return failed(info.error());
  }
  return created(*info, "/api/v1/cores/" + (*core)->id());
}

}  // namespace race::server
