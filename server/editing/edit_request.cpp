#include "server/editing/edit_request.h"

#include <limits>

#include "core/language/primitives/utf8.h"
#include "core/rcm/ids.h"
#include "server/store/documents.h"

namespace race::server {
namespace {

std::string read_text(Fields& fields, const char* name, std::size_t most) {
  std::string text = fields.text(name).value_or("");
  if (language::utf8::length(text) > most)
    fields.violation(ErrorCode::too_large, "has more than " + std::to_string(most) + " characters", name);
  return text;
}

std::string read_token(Fields& fields) {
  const auto token = fields.text("request");
  if (token && !rcm::is_id(*token))
    fields.violation(ErrorCode::name, "a request is named by 1 to 64 of A-Z a-z 0-9 _ -", "request");
  return token.value_or("");
}

void read_take_back(Fields& fields, const char* name) {
  const auto is_asked_for = fields.boolean(name);
  if (is_asked_for && !*is_asked_for)
    fields.violation(ErrorCode::out_of_range, "`" + std::string(name) + "` is true or absent", name);
}

}  // namespace

EditRequest read_edit_request(Fields& fields, std::vector<Error>& errors) {
  EditRequest out;
  if (const auto revision = fields.integer("revision", 1, std::numeric_limits<std::int64_t>::max()))
    out.revision = static_cast<edit::Revision>(*revision);
  out.author = read_text(fields, "author", Documents::kMaxAuthor);
  out.message = read_text(fields, "message", Documents::kMaxMessage);
  out.token = read_token(fields);
  const Value *operations = fields.find("operations"), *compound = fields.find("compound");
  const Value *undo = fields.find("undo"), *redo = fields.find("redo");
  const int asked = (operations ? 1 : 0) + (compound ? 1 : 0) + (undo ? 1 : 0) + (redo ? 1 : 0);
  if (asked != 1) {
    fields.violation(ErrorCode::missing, "needs exactly one of `operations`, `compound`, `undo`, `redo`", "operations");
    return out;
  }
  if (operations) {
    auto edit = edit::read_edit(Dict{{"operations", *operations}});
    if (edit)
      out.what = std::move(*edit);
    else
      errors.insert(errors.end(), edit.error().begin(), edit.error().end());
  } else if (compound) {
    out.what = read_compound(*compound, errors);
  } else {
    read_take_back(fields, undo ? "undo" : "redo");
    out.what = undo ? EditRequest::TakeBack::undo : EditRequest::TakeBack::redo;
  }
  return out;
}

}  // namespace race::server
