// GET and POST /api/v1/cell/person: what the hands at the cell hold, and what they do next.
#include "core/value/json.h"
#include "server/cell/person_act.h"
#include "server/handlers/handlers.h"

namespace race::server {

namespace {

Handled at_cell(Application& app, const std::optional<PersonAct>& act) {
  if (const auto world = world_of(app); !world) return tl::unexpected(world.error());
  return answer(app.cell().act(act));
}

}  // namespace

Handled get_person(const Request&, Application& app) { return at_cell(app, std::nullopt); }

Handled act_as_person(const Request& request, Application& app) {
  const auto body = parse_json(request.body);
  if (!body) return failed(body.error());
  auto act = read_person_act(*body, kClientPatience);
  if (!act) return tl::unexpected(std::move(act).error());
  return at_cell(app, std::move(*act));
}

}  // namespace race::server
