#include "server/wire/errors.h"

namespace race::server {

Value errors_json(const std::vector<Error>& errors) {
  List list;
  for (const Error& error : errors) {
    Dict json{{"path", error.path}, {"code", name(error.code)}, {"message", error.message}};
    if (error.where.line > 0) {
      json.set("line", error.where.line);
      json.set("column", error.where.column);
    }
    list.emplace_back(std::move(json));
  }
  return Dict{{"errors", std::move(list)}};
}

}  // namespace race::server
