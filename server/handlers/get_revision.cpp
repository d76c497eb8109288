// GET /api/v1/documents/{name}/revisions/{revision}: a document as it was.
#include <charconv>

#include "server/handlers/document_requests.h"

namespace race::server {

Handled get_revision(const Request& request, Documents& documents) {
  const std::string& text = request.parameters.at("revision");
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    return failed({ErrorCode::not_found, "there is no revision of this number", text});
  return answer_entry(documents.entry(request.parameters.at("name"), number));
}

}  // namespace race::server
