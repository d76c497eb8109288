// POST /api/v1/cores: a core of a document and arguments, which waits to be started.
#include "core/value/json.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/store/documents.h"

namespace race::server {

Handled create_core(const Request& request, Documents& documents, Cores& cores) {
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
  const auto core = cores.create(*stored, std::move(arguments).value_or(Dict()));
  if (!core) return tl::unexpected(core.error());
  Reply reply = ok((*core)->info());
  reply.status = 201;
  return reply;
}

}  // namespace race::server
