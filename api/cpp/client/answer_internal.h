// Parts of answers. Error `protocol`: the answer has no such field.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "api/cpp/client/api_error.h"

namespace race::client {

inline tl::unexpected<ApiError> missing(std::string_view field) {
  return failure(kProtocol, "an answer has no `" + std::string(field) + "`: not a server of RACE?", true);
}

inline Answered<List> list_in(const Value& answer, std::string_view field) {
  const Value* const found = answer.find(field);
  if (!found || !found->is_list()) return missing(field);
  return found->as_list();
}

inline Answered<std::string> text_in(const Value& answer, std::string_view field) {
  const Value* const found = answer.find(field);
  if (!found || !found->is_string()) return missing(field);
  return found->as_string();
}

inline Answered<std::int64_t> integer_in(const Value& answer, std::string_view field) {
  const Value* const found = answer.find(field);
  if (!found || !found->is_integer()) return missing(field);
  return found->as_integer();
}

}  // namespace race::client
