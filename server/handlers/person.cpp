// GET and POST /api/v1/cell/person: what the hands at the cell hold, and what they do next.
#include "core/value/json.h"
#include "server/cell/cell.h"
#include "server/cell/person_command.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Handled execute(Cell& cell, const std::optional<PersonCommand>& command) {
  if (const auto world = world_of(cell); !world) return tl::unexpected(world.error());
  return answer(cell.execute(command));
}

}  // namespace

Handled get_person(const Request&, Cell& cell) { return execute(cell, std::nullopt); }

Handled execute_person_command(const Request& request, Cell& cell) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  auto command = read_person_command(*body, kClientKeep);
  if (!command) return tl::unexpected(std::move(command).error());
  return execute(cell, std::move(*command));
}

}  // namespace race::server
