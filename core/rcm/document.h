// The RCM codec: documents (core/SEMANTICS.md, section 1) from JSON and back. A document is rejected as a whole, with
// its violations (constraints.h). A draft keeps what has the right shape, even if it breaks other constraints.
// Pure functions.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::rcm {

/// What could be read of a document, and what is wrong with its shape: `version`, `missing`, `type`, `unknown_field`,
/// `constant`, `oracle` (an unknown kind). An element that could not be read is left out; a nameless node has the empty
/// name.
struct Draft {
  Document document;
  std::vector<Error> errors;
  bool has_root = false;
  std::size_t bad_ids = 0;  // how many ids (`meta.id`) are none; they are left out, and each is one of the errors
                            // unless these are full
};

/// Reads as much as can be read. `json` is a document as parse_json gives it with `keep_out_of_range`.
Draft read_draft(const Value& json);

/// Reads a document and checks its shape and all constraints (constraints.h).
Checked<Document> read_document(const Value& json);

/// As read_document, from a text. Its own codes, with an empty path: `json`, `too_deep`, `too_large`.
Checked<Document> read_document_text(std::string_view text);

/// The JSON of a document, fields in the order of the format, the entries of `meta`, `layout` and notes in order of
/// their keys (entries.h); empty lists, texts and null are left out. Reading it gives an equal document, if `document`
/// was read.
Value write_document(const Document& document);

/// The JSON of a state and all below it, such as the root of a native model.
Value write_state(const State& state);

/// The text of a document as files hold it, two spaces a level, with a new line at the end. It is stable: an edit of
/// one element changes that element's lines alone, if its commas are not counted (the one of the line before appears
/// with the last element of a list). So every element of a list stands on its own lines, a state always on several;
/// another list or object on one line, if it holds no more than one level of lists and objects and fits into 120
/// columns. `services`, `layout` and the `notes` of the document's meta have one line for each entry. Entries are in
/// order as write_document has them.
std::string format_document(const Document& document);

/// The same for a text that is stored or written to a file. Ids and indentation make a text longer and deeper than what
/// was read; errors `too_large`, `too_deep`: read_document_text could not read it again.
Expected<std::string> write_document_text(const Document& document);

}  // namespace race::rcm
