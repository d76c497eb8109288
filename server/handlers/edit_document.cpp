// POST /api/v1/documents/{name}/edits: edits a document as it is now, whatever others have done since its author saw
// it.
#include <charconv>

#include "core/value/json.h"
#include "server/editing/editing.h"
#include "server/handlers/document_requests.h"
#include "server/http/refusal.h"

namespace race::server {
namespace {

/// The revision of the header If-Match, a strong tag; nothing: it is absent. Error `out_of_range`.
Expected<std::optional<edit::Revision>> if_match(const Request& request) {
  if (request.count("if-match") == 0) return std::nullopt;
  const std::string_view tag = request.header("if-match");
  edit::Revision revision = 0;
  const char* const end = tag.data() + tag.size();
  const bool is_quoted = tag.size() > 2 && tag.front() == '"' && tag.back() == '"';
  if (request.count("if-match") > 1 || !is_quoted ||
      std::from_chars(tag.data() + 1, end - 1, revision).ptr != end - 1 || revision == 0)
    return unexpected(ErrorCode::out_of_range, "must be one strong tag of a revision, such as \"3\"", "If-Match");
  return revision;
}

Reply refuse(int status, const std::vector<Error>& errors) {
  Reply reply = refusal(errors);
  reply.status = status;
  return reply;
}

/// As errors of other routes, but what an edit names in the document and does not find is a violation of the edit.
Reply refuse(const EditRefusal& refusal_of) {
  const ErrorCode code = refusal_of.errors.front().code;
  if (refusal_of.of == EditRefusal::Of::precondition) return refuse(412, refusal_of.errors);
  if (refusal_of.of == EditRefusal::Of::edit && code == ErrorCode::not_found) return refuse(422, refusal_of.errors);
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
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  if (!edit.revision) edit.revision = edit.if_match;
  if (!edit.revision)
    return refuse(400, {{ErrorCode::missing, "the field `revision` is missing, and so is If-Match", "revision"}});
  auto edited = editing.edit(request.parameters.at("name"), edit);
  if (!edited) return refuse(edited.error());
  return ok(std::move(edited->edit));
}

}  // namespace race::server
