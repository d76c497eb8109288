// Call: a request that was not sent yet. calls.h has a function for each route that makes one; Client::send() sends it.
//
// Threads: a value; each belongs to one.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/value/value.h"

namespace race::client {

struct Call {
  std::string method;  // "GET"
  std::string target;  // path and query, encoded
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::optional<Value> body = {};
  bool is_text = false;  // the answer is a text of another type than JSON
};

/// A value as it stands in a path or query, before it is encoded: of a bool, `true` or `false`.
inline std::string text_of(std::string_view value) { return std::string(value); }
inline std::string text_of(std::int64_t value) { return std::to_string(value); }
template <std::same_as<bool> Bool>
std::string text_of(Bool value) {
  return value ? "true" : "false";
}

/// A value as one part of a path, encoded.
std::string segment(std::string_view text);
inline std::string segment(std::int64_t number) { return segment(text_of(number)); }

/// Adds a parameter to the query.
void add_query_text(Call& call, std::string_view name, std::string_view text);
template <typename T>
void add_query(Call& call, std::string_view name, const T& value) {
  add_query_text(call, name, text_of(value));
}
/// The same, if there is a value.
template <typename T>
void add_query(Call& call, std::string_view name, const std::optional<T>& value) {
  if (value) add_query_text(call, name, text_of(*value));
}
/// Adds a header, if it has a value.
void add_header(Call& call, std::string_view name, const std::optional<std::string>& value);

}  // namespace race::client
