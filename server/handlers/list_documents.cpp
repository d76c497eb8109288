// GET /api/v1/documents: names and revisions.
#include "server/handlers/handlers.h"

namespace race::server {

Handled list_documents(const Request&, Application& app) {
  const auto documents = app.documents().list();
  if (!documents) return tl::unexpected(documents.error());
  List list;
  for (const StoredDocument& stored : *documents) {
    Dict entry{{"name", stored.name}, {"revision", stored.revision}};
    if (!stored.document.root.doc.empty()) entry.set("doc", stored.document.root.doc);
    list.emplace_back(std::move(entry));
  }
  return ok(Dict{{"documents", std::move(list)}});
}

}  // namespace race::server
