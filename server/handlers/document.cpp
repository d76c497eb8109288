// GET and PUT /api/v1/documents/{name}: one document or draft as it is edited; stored whole or refused whole.
#include "server/editing/editing.h"
#include "server/handlers/document_requests.h"
#include "server/handlers/preconditions.h"
#include "server/handlers/query.h"

namespace race::server {
namespace {

Expected<bool> is_draft(const Request& request) {
  const std::string draft = query_text(request, "draft");
  if (draft.empty() || draft == "false") return false;
  if (draft == "true") return true;
  return unexpected(ErrorCode::out_of_range, "must be `true` or `false`", "draft");
}

}  // namespace

Handled get_document(const Request& request, Documents& documents) {
  return answer_unless_known(request, documents.entry(request.parameters.at("name")));
}

Handled put_document(const Request& request, Editing& editing) {
  const auto draft = is_draft(request);
  if (!draft) return failed(draft.error());
  const auto seen = query_number(request, "revision");
  if (!seen) return failed(seen.error());
  const auto match = if_match(request);
  if (!match) return failed(match.error());
  const auto is_new = requires_absence(request);
  if (!is_new) return failed(is_new.error());
  if (*seen && *match && *seen != *match)
    return failed({ErrorCode::out_of_range, "`revision` and If-Match name different revisions", "revision"});
  const Documents::Put options{*draft, *match ? *match : *seen, *is_new};
  const auto change = change_of(request);
  if (!change) return failed(change.error());
  return answer_changed(editing.put(request.parameters.at("name"), request.body, *change, options), *match || *is_new);
}

}  // namespace race::server
