#include "server/store/document_text.h"

#include "core/language/primitives/utf8.h"
#include "core/rcm/constraints.h"
#include "core/rcm/document.h"
#include "core/rcm/ids.h"
#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::server {
namespace {

constexpr std::size_t kMaxDoc = 1000;

/// Gives ids as the next revision of `previous`, which may have violations: ids are kept all the same.
void give_ids_after(std::string_view previous, rcm::Document& document) {
  const auto json = parse_json(previous, JsonLimits{.keep_out_of_range = true});
  if (!json) return rcm::give_ids(document);
  const rcm::Draft draft = rcm::read_draft(*json);
  rcm::give_ids(document, &draft.document);
}

}  // namespace

std::string doc_of(const rcm::Document& document) {
  const std::string& all = document.root.doc;
  return all.substr(0, language::utf8::offset(all, kMaxDoc));
}

Checked<DocumentText> read_document_or_draft(std::string_view text) {
  auto json = parse_json(text, JsonLimits{.keep_out_of_range = true});
  if (!json) return tl::unexpected(std::vector<Error>{std::move(json).error()});
  rcm::Draft draft = rcm::read_draft(*json);
  std::vector<Error> errors = rcm::violations(draft);
  if (!json->is_dict() || has_number_out_of_range(*json)) return tl::unexpected(std::move(errors));
  const bool is_whole = draft.has_root && draft.errors.empty();
  return DocumentText{std::move(*json), std::move(draft.document), is_whole, std::move(errors)};
}

Expected<std::string> next_text(DocumentText& document, std::string_view text, std::string_view previous) {
  if (!document.is_whole) return std::string(text);
  give_ids_after(previous, document.document);
  auto next = rcm::write_document_text(document.document);
  if (next) document.json = rcm::write_document(document.document);
  return next;
}

}  // namespace race::server
