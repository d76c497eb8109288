// GET /api/v1/documents: names, revisions, and how many errors each has.
#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

Handled list_documents(const Request&, Documents& documents) {
  const auto stored = documents.list();
  if (!stored) return tl::unexpected(stored.error());
  List list;
  for (const Revision& last : *stored) {
    Dict entry{{"name", last.document}, {"revision", last.number}, {"errors", last.errors}};
    if (!last.doc.empty()) entry.set("doc", last.doc);
    list.emplace_back(std::move(entry));
  }
  return ok(Dict{{"documents", std::move(list)}});
}

}  // namespace race::server
