// POST /api/v1/cores/{id}/load: another document, its last revision, or other arguments in a core that has not begun.
#include "core/value/json.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

Handled load_core(const Request& request, Documents& documents, Cores& cores) {
  auto body = parse_json(request.body);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const auto name = fields.text("document", Fields::Need::required);
  auto arguments = read_arguments(fields);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  const auto stored = documents.get(*name);
  if (!stored) return tl::unexpected(stored.error());
  const auto core = cores.load(request.parameters.at("id"), *stored, std::move(arguments).value_or(Dict()));
  if (!core) return tl::unexpected(core.error());
  return ok((*core)->info());
}

}  // namespace race::server
