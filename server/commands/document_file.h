// Documents as files NAME.rcm.json, for keeping them in git. Pure, but for read_document_file().
#pragma once

#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

/// "pick.rcm.json"
std::string document_file_name(std::string_view name);

/// The name of the document in this file: "models/pick.rcm.json" has `pick`. Error `name`, with the path: the file has
/// not the name of one.
Expected<std::string> document_name_of(const std::string& path);

/// The text of a document as a file holds it: as `race fmt` writes it; of a draft whose shape is wrong, JSON.
std::string document_text(const Value& document);

struct DocumentFile {
  std::string bytes;         // as the file is
  Expected<Value> document;  // or why it is no JSON, with the path of the file
  std::string text;          // as it should be, which is compared; what is no JSON, as it is
};

/// Errors, with the path: `io`, `too_large`.
Expected<DocumentFile> read_document_file(const std::string& path);

/// SHA-256 of a text, in 64 hexadecimal digits.
std::string hash_of(std::string_view text);

}  // namespace race::server
