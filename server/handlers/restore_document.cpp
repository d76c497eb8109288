// POST /api/v1/documents/{name}/restore: makes an earlier revision the next one.
#include "core/value/json.h"
#include "server/editing/editing.h"
#include "server/handlers/document_requests.h"
#include "server/handlers/preconditions.h"

namespace race::server {

Handled restore_document(const Request& request, Editing& editing) {
  const auto match = if_match(request);
  if (!match) return failed(match.error());
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const auto revision = read_revision_number(fields, Fields::Need::required);
  const Change change = read_change(fields, request, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return answer_changed(editing.restore(request.parameters.at("name"), *revision, change, *match), match->has_value());
}

}  // namespace race::server
