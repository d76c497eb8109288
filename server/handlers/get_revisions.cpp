// GET /api/v1/documents/{name}/revisions?before=&limit=: who changed a document, when and why; the newest first.
#include <algorithm>

#include "server/handlers/document_requests.h"
#include "server/handlers/query.h"

namespace race::server {

Handled get_revisions(const Request& request, Documents& documents) {
  constexpr std::int64_t kMost = 100;
  const auto before = query_number(request, "before"), limit = query_number(request, "limit", {1, kMost});
  if (!before) return failed(before.error());
  if (!limit) return failed(limit.error());
  const std::string& name = request.parameters.at("name");
  const auto most = limit->value_or(kMost);
  const auto revisions = documents.revisions(name, *before, most);
  if (!revisions) return tl::unexpected(revisions.error());
  List list;
  std::ranges::transform(*revisions, std::back_inserter(list), revision_json);
  Dict json{{"name", name}, {"revisions", std::move(list)}};
  const bool is_full = revisions->size() == static_cast<std::size_t>(most);
  if (is_full && revisions->back().number > 1) json.set("next", revisions->back().number);
  return ok(std::move(json));
}

}  // namespace race::server
