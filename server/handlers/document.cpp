// GET and PUT /api/v1/documents/{name}: one document as it is edited; stored whole or refused whole.
#include "core/rcm/document.h"

#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

namespace {

Handled entry(const Checked<StoredDocument>& stored) {
  if (!stored) return tl::unexpected(stored.error());
  return ok(Dict{
      {"name", stored->name}, {"revision", stored->revision}, {"document", rcm::write_document(stored->document)}});
}

}  // namespace

Handled get_document(const Request& request, Documents& documents) {
  return entry(documents.get(request.parameters.at("name")));
}

Handled put_document(const Request& request, Documents& documents) {
  return entry(documents.put(request.parameters.at("name"), request.body));
}

}  // namespace race::server
