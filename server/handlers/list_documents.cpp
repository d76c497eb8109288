// GET /api/v1/documents?after=&limit=: names, revisions, and how many errors each has; damaged ones as errors.
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"
#include "server/store/documents.h"
#include "server/wire/errors.h"

namespace race::server {

Handled list_documents(const Request& request, Documents& documents) {
  constexpr std::int64_t kMost = 1000;
  const auto limit = query_number(request, "limit", {1, kMost});
  if (!limit) return failed(limit.error());
  const auto stored = documents.heads(query_text(request, "after"), limit->value_or(kMost));
  if (!stored) return failed(stored.error());
  List list;
  for (const Revision& last : stored->revisions) {
    Dict entry{{"name", last.document}, {"revision", last.number}, {"errors", last.errors}};
    if (!last.doc.empty()) entry.set("doc", last.doc);
    list.emplace_back(std::move(entry));
  }
  Dict json{{"documents", std::move(list)}};
  if (!stored->next.empty()) json.set("next", stored->next);
  if (!stored->damaged.empty()) json.set("damaged", error_list(stored->damaged));
  return ok(std::move(json));
}

}  // namespace race::server
