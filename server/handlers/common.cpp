#include "server/handlers/handlers.h"

namespace race::server {

Reply ok(Value body) {
  Reply reply;
  reply.body = std::move(body);
  return reply;
}

tl::unexpected<std::vector<Error>> failed(Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); }

Checked<std::shared_ptr<Core>> core_of(const Request& request, Application& app) {
  auto core = app.cores().find(request.parameters.at("id"));
  if (!core) return failed(std::move(core).error());
  return std::move(*core);
}

Handled answer(Expected<Value> value) {
  if (!value) return failed(std::move(value).error());
  return ok(std::move(*value));
}

}  // namespace race::server
