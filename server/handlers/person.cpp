// GET and POST /api/v1/cell/person: what the hands at the cell hold, and what they do next.
#include "core/value/json.h"
#include "server/cell/person_command.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Handled at_cell(Application& app, const std::optional<PersonCommand>& command) {
  if (const auto world = world_of(app); !world) return tl::unexpected(world.error());
  return answer(app.cell().execute(command));
}

}  // namespace

Handled get_person(const Request&, Application& app) { return at_cell(app, std::nullopt); }

Handled execute_person_command(const Request& request, Application& app) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  auto command = read_person_command(*body, kClientKeep);
  if (!command) return tl::unexpected(std::move(command).error());
  return at_cell(app, std::move(*command));
}

}  // namespace race::server
