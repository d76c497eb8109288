// GET and POST /api/v1/cell/person: what the hands at the cell hold, and what they do next.
#include "core/value/json.h"
#include "server/cell/cell.h"
#include "server/cell/person_command.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

void execute(Respond respond, Cell& cell, Deadlines& deadlines, const std::optional<PersonCommand>& command) {
  if (const auto world = world_of(cell); !world) return respond(tl::unexpected(world.error()));
  cell.execute(command, deadlines, answer_to(std::move(respond)));
}

}  // namespace

void get_person(const Request&, Respond respond, Cell& cell, Deadlines& deadlines) {
  execute(std::move(respond), cell, deadlines, std::nullopt);
}

void execute_person_command(const Request& request, Respond respond, Cell& cell, Deadlines& deadlines) {
  const auto body = parse_json(request.body);
  if (!body) return respond(failed(body.error()));
  auto command = read_person_command(*body, kClientKeep);
  if (!command) return respond(tl::unexpected(std::move(command).error()));
  // A hand that is dragged asks thirty times a second.
  if (std::holds_alternative<DragCommand>(command->what)) respond = as_routine(std::move(respond));
  execute(std::move(respond), cell, deadlines, std::move(*command));
}

}  // namespace race::server
