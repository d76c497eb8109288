// POST /api/v1/documents/{name}/branch: makes a revision the first one of a document of its own.
#include "core/value/json.h"
#include "server/editing/editing.h"
#include "server/handlers/document_requests.h"

namespace race::server {

Handled branch_document(const Request& request, Editing& editing) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const auto as = fields.text("as", Fields::Need::required);
  const auto revision = read_revision_number(fields, Fields::Need::optional);
  const Change change = read_change(fields, request, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return answer_entry(editing.branch(request.parameters.at("name"), {*as, revision}, change));
}

}  // namespace race::server
