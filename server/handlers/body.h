// The body of a request: an object whose fields a handler reads.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/value/expected.h"
#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::server {

/// What `read` makes of the fields of a body. Errors: those of parse_json(); what `read` says of its fields; a field
/// that it has not read.
template <typename Read>
auto read_body(const std::string& text, Read read) -> Checked<std::invoke_result_t<Read, Fields&>> {
  auto body = parse_json(text);
  if (!body) return tl::unexpected(std::vector<Error>{std::move(body).error()});
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  auto value = read(fields);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return value;
}

}  // namespace race::server
