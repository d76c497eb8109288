#include "server/cell/cell.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

namespace race::server {

Reply ok(Value body) {
  Reply reply;
  reply.body = std::move(body);
  return reply;
}

Reply created(Value body, std::string path) {
  Reply reply = ok(std::move(body));
  reply.status = 201;
  reply.headers.emplace_back("Location", std::move(path));
  return reply;
}

tl::unexpected<std::vector<Error>> failed(Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); }

std::optional<Dict> read_arguments(Fields& fields) {
  const Value* arguments = fields.find("arguments");
  if (!arguments) return std::nullopt;
  if (arguments->is_dict()) return arguments->as_dict();
  fields.violation(ErrorCode::type, "`arguments` must be an object", "arguments");
  return std::nullopt;
}

Checked<std::shared_ptr<Core>> core_of(const Request& request, const Cores& cores) {
  auto core = cores.find(request.parameters.at("id"));
  if (!core) return failed(std::move(core).error());
  return std::move(*core);
}

Checked<CellWorld*> world_of(Cell& cell) {
  if (CellWorld* world = cell.world()) return world;
  return failed({ErrorCode::not_found, "there is no world here: the server has no cell"});
}

Handled answer(Expected<Value> value) {
  if (!value) return failed(std::move(value).error());
  return ok(std::move(*value));
}

Respond as_routine(Respond respond) {
  return [respond = std::move(respond)](Handled handled) {
    if (handled) handled->is_routine = true;
    respond(std::move(handled));
  };
}

Done<Value> answer_to(Respond respond) {
  return [respond = std::move(respond)](Expected<Value> value) { respond(answer(std::move(value))); };
}

}  // namespace race::server
