// POST /api/v1/documents/{name}/edits: edits a document as it is now, whatever others have done since its author saw
// it.
#include "core/value/json.h"
#include "server/accounts/gate.h"
#include "server/editing/editing.h"
#include "server/handlers/handlers.h"
#include "server/handlers/preconditions.h"
#include "server/http/refusal.h"

namespace race::server {
namespace {

/// As errors of other routes, but what an edit names in the document and does not find is a violation of the edit.
Reply refuse(const EditRefusal& refusal_of) {
  const ErrorCode code = refusal_of.errors.front().code;
  if (refusal_of.of == EditRefusal::Of::precondition) return refusal(412, refusal_of.errors);
  if (refusal_of.of == EditRefusal::Of::edit && code == ErrorCode::not_found) return refusal(422, refusal_of.errors);
  return refusal(refusal_of.errors);
}

}  // namespace

Handled edit_document(const Request& request, Editing& editing) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  auto precondition = if_match(request);
  if (!precondition) return failed(std::move(precondition).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  EditRequest edit = read_edit_request(fields, errors);
  fields.close();
  edit.if_match = *precondition;
  if (auto author = author_for(request.identity, std::move(edit.author)))
    edit.author = std::move(*author);
  else
    errors.push_back(std::move(author).error());
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (!edit.revision) edit.revision = edit.if_match;
  if (!edit.revision) {
    const Error missing{ErrorCode::missing, "the field `revision` is missing, and so is If-Match", "revision"};
    return refusal(400, std::vector<Error>{missing});
  }
  auto edited = editing.edit(request.parameters.at("name"), edit);
  if (!edited) return refuse(edited.error());
  const std::int64_t revision = edited->edit.find("revision")->as_integer();
  Reply reply = ok(std::move(edited->edit));
  add_tag(reply, revision);
  return reply;
}

}  // namespace race::server
