// GET and PUT /api/v1/documents/{name}: one document or draft as it is edited; stored whole or refused whole.
#include "server/editing/editing.h"
#include "server/handlers/document_requests.h"

namespace race::server {
namespace {

Expected<bool> is_draft(const Request& request) {
  const auto found = request.query.find("draft");
  if (found == request.query.end() || found->second == "false") return false;
  if (found->second == "true") return true;
  return unexpected(ErrorCode::out_of_range, "must be `true` or `false`", "draft");
}

}  // namespace

Handled get_document(const Request& request, Documents& documents) {
  const auto entry = documents.entry(request.parameters.at("name"));
  auto reply = answer_entry(entry);
  if (reply) reply->headers.emplace_back("ETag", "\"" + std::to_string(entry->revision.number) + "\"");
  return reply;
}

Handled put_document(const Request& request, Editing& editing) {
  const auto draft = is_draft(request);
  if (!draft) return failed(draft.error());
  const auto seen = number_of(request, "revision");
  if (!seen) return failed(seen.error());
  const Documents::Put options{*draft, *seen};
  return answer_entry(editing.put(request.parameters.at("name"), request.body, change_of(request), options));
}

}  // namespace race::server
