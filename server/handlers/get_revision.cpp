// GET /api/v1/documents/{name}/revisions/{revision}: a document as it was.
#include "server/handlers/document_requests.h"
#include "server/handlers/query.h"

namespace race::server {

Handled get_revision(const Request& request, Documents& documents) {
  const std::string& text = request.parameters.at("revision");
  const auto number = whole_number(text);
  if (!number) return failed({ErrorCode::not_found, "there is no revision of this number", text});
  return answer_unless_known(request, documents.entry(request.parameters.at("name"), *number));
}

}  // namespace race::server
