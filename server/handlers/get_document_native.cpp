// GET /api/v1/documents/{name}/native: what executes, and where each element came from.
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

Handled get_document_native(const Request& request, Documents& documents) {
  const auto stored = documents.get(request.parameters.at("name"));
  if (!stored) return tl::unexpected(stored.error());
  auto native = native_json(stored->document);
  if (!native) return tl::unexpected(std::move(native).error());
  return ok(std::move(*native));
}

}  // namespace race::server
