// GET /api/v1/documents: names and revisions.
#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

Handled list_documents(const Request&, Documents& documents) {
  const auto stored = documents.list();
  if (!stored) return tl::unexpected(stored.error());
  List list;
  for (const StoredDocument& document : *stored) {
    Dict entry{{"name", document.name}, {"revision", document.revision}};
    if (!document.document.root.doc.empty()) entry.set("doc", document.document.root.doc);
    list.emplace_back(std::move(entry));
  }
  return ok(Dict{{"documents", std::move(list)}});
}

}  // namespace race::server
