#include "server/wire/errors.h"

#include <algorithm>

#include "core/value/error_list.h"

namespace race::server {

List error_list(std::span<const Error> errors) {
  List list;
  for (const Error& error : errors) {
    Dict json{{"path", error.path}, {"code", name(error.code)}, {"message", error.message}};
    if (!error.id.empty()) json.set("id", error.id);
    if (!error.text.empty()) json.set("text", error.text);
    if (error.where.line > 0) {
      json.set("line", error.where.line);
      json.set("column", error.where.column);
    }
    list.emplace_back(std::move(json));
  }
  return list;
}

void set_errors(Dict& json, const std::vector<Error>& errors) {
  json.set("errors", error_list(std::span(errors).first(std::min(errors.size(), kMaxErrors))));
  if (is_full(errors)) json.set("more_errors", true);
}

Value errors_json(const std::vector<Error>& errors) {
  Dict json;
  set_errors(json, errors);
  return json;
}

}  // namespace race::server
