// A document in a store, and edits of it, for tests.
#pragma once

#include "core/edit/apply.h"
#include "core/edit/tree.h"
#include "core/value/json.h"
#include "server/store/document_text.h"
#include "tests/unit/server/document_store.h"

namespace race::server {

/// R with A and B, which have these names as ids.
inline constexpr const char* kWithIds =
    R"({"rcm": 1, "root": {"state": "R", "meta": {"id": "r"}, "children": [)"
    R"({"state": "A", "meta": {"id": "a"}}, {"state": "B", "meta": {"id": "b"}}]}})";

inline edit::Edit set_doc(const std::string& id, const std::string& text) {
  return {{edit::Operation{edit::Set{id, "doc", {}, Value(text)}}}};
}

/// The last revision's text after the edit, as Documents::append_edit wants it.
inline RevisionText next_of(Documents& documents, const edit::Edit& edit, const std::string& author = "Ada") {
  const DocumentEntry last = documents.entry("task").value();
  edit::Tree tree = edit::Tree::read(rcm::read_document(last.document).value()).value();
  EXPECT_TRUE(edit::apply(tree, edit));
  const rcm::Document document = tree.document();
  return {{"task", last.revision.number + 1, {author, "", 1}, {Origin::Kind::edit}, 0, doc_of(document)},
          rcm::write_document_text(document).value()};
}

inline Expected<void> append(Documents& documents, const edit::Edit& edit, const std::string& token = "") {
  return documents.append_edit(next_of(documents, edit), {edit, token});
}

}  // namespace race::server
