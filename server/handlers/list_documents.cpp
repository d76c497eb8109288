// GET /api/v1/documents: names, revisions, and how many errors each has; damaged ones as errors.
#include "server/handlers/handlers.h"
#include "server/store/documents.h"
#include "server/wire/errors.h"

namespace race::server {

Handled list_documents(const Request&, Documents& documents) {
  const auto stored = documents.heads();
  if (!stored) return failed(stored.error());
  List list;
  for (const Revision& last : stored->revisions) {
    Dict entry{{"name", last.document}, {"revision", last.number}, {"errors", last.errors}};
    if (!last.doc.empty()) entry.set("doc", last.doc);
    list.emplace_back(std::move(entry));
  }
  Dict json{{"documents", std::move(list)}};
  if (!stored->damaged.empty()) json.set("damaged", *errors_json(stored->damaged).find("errors"));
  return ok(std::move(json));
}

}  // namespace race::server
