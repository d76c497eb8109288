// The body of requests that set breakpoints: `{"breakpoints": [...]}`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/handlers/handlers.h"

namespace race::server {

/// The list in the body, each breakpoint read by `read`, which gets its Fields. Refused whole, with all errors.
template <typename Read>
auto read_breakpoint_list(const std::string& text, Read read)
    -> Checked<std::vector<decltype(read(std::declval<Fields&>()))>> {
  auto body = parse_json(text);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const List& list = fields.list("breakpoints", Fields::Need::required);
  fields.close();
  std::vector<decltype(read(fields))> all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Fields of_one(list[i], "breakpoints/" + std::to_string(i), "a breakpoint", errors, Fields::Paths::field);
    all.push_back(read(of_one));
    of_one.close();
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return all;
}

}  // namespace race::server
