#include "server/handlers/core_model.h"

#include "core/value/fields.h"
#include "core/value/json.h"
#include "server/handlers/handlers.h"

namespace race::server {

Checked<CoreModel> read_core_model(const Request& request, Documents& documents) {
  auto body = parse_json(request.body);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const auto name = fields.text("document", Fields::Need::required);
  auto arguments = read_arguments(fields);
  const auto live = fields.boolean("live");
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  auto document = documents.get(*name);
  if (!document) return tl::unexpected(std::move(document).error());
  return CoreModel{std::move(*document), std::move(arguments).value_or(Dict()), live};
}

}  // namespace race::server
