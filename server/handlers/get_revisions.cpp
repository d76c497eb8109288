// GET /api/v1/documents/{name}/revisions?before=&limit=: who changed a document, when and why; the newest first.
#include <algorithm>

#include "server/handlers/document_requests.h"

namespace race::server {

Handled get_revisions(const Request& request, Documents& documents) {
  constexpr std::int64_t kMost = 100;
  const auto before = number_of(request, "before"), limit = number_of(request, "limit");
  if (!before) return failed(before.error());
  if (!limit) return failed(limit.error());
  if (limit->value_or(1) > kMost)
    return failed({ErrorCode::out_of_range, "must be a number from 1 to " + std::to_string(kMost), "limit"});
  const std::string& name = request.parameters.at("name");
  const auto revisions = documents.revisions(name, *before, limit->value_or(kMost));
  if (!revisions) return tl::unexpected(revisions.error());
  List list;
  std::ranges::transform(*revisions, std::back_inserter(list), revision_json);
  return ok(Dict{{"name", name}, {"revisions", std::move(list)}});
}

}  // namespace race::server
