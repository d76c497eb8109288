// JSON: reads a text as a Value and writes a Value as text. The only user of nlohmann is json.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race {

/// Limits of a text that is read.
struct JsonLimits {
  std::size_t depth = 64;                // levels of lists and dicts
  std::size_t bytes = 16 * 1024 * 1024;  // of text
  /// A number out of the range of int64 or double is an error `constant`. If this is true, an integer out of range is
  /// read as the unknown value, so that the reader of the document can report its path; 1e999 remains an error.
  bool keep_out_of_range = false;
};

/// Reads one JSON document (UTF-8). Errors: `json` (not JSON, bad UTF-8, text after it, a duplicate key), `too_deep`,
/// `too_large`, `constant`.
Expected<Value> parse_json(std::string_view text, const JsonLimits& limits = {});

/// Writes JSON: one line, or with `indent` spaces a level. Doubles keep their value (shortest text that reads back the
/// same) and are recognisable as doubles (`1.0`). Requires finite doubles and no unknown inside; strings are valid
/// UTF-8.
std::string to_json(const Value& value, int indent = -1);

/// to_json on one line, added to the end of `out`.
void append_json(const Value& value, std::string& out);
/// The same of a string.
void append_json_string(std::string_view text, std::string& out);

}  // namespace race
