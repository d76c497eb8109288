// DocumentText: the text of a document or of a draft of one, read as far as it can be. Pure functions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/model.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

struct DocumentText {
  Value json;                 // an object
  rcm::Document document;     // what of it has the right shape
  bool is_whole = false;      // all of it has: `document` says all that the text says
  std::vector<Error> errors;  // its violations (rcm::violations); none: it is a document
};

/// The beginning of the root's `doc`: at most 1000 code points.
std::string doc_of(const rcm::Document& document);

/// Errors, of a text that is no draft either: `json`, `too_large`, `too_deep`, `type` (no object), and all violations
/// if it has a number out of range, which a Value cannot hold.
Checked<DocumentText> read_document_or_draft(std::string_view text);

/// The text to store as the next revision after `previous` (empty: there is none): as files hold it (`race fmt`), with
/// ids, where they are missing those of `previous`; a draft whose shape is wrong stays as it came, as nothing of it may
/// get lost. Puts what it stores into `document`. Errors `too_large`, `too_deep`: with ids it could not be read again.
Expected<std::string> next_text(DocumentText& document, std::string_view text, std::string_view previous);

}  // namespace race::server
