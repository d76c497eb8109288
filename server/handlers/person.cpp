// GET and POST /api/v1/cell/person: what the hands at the cell hold, and what they do next.
#include "core/value/json.h"
#include "server/cell/person_act.h"
#include "server/cell/scene_json.h"
#include "server/handlers/handlers.h"

namespace race::server {
namespace {

/// Does `work` where the world lives and answers with schemas/person.json as it is then.
Handled at_cell(Application& app, std::function<Expected<void>(world::Person&)> work) {
  Cell& cell = app.cell();
  if (!cell.has_world())
    return failed({ErrorCode::not_found,
                   "there is no world here: the server has no cell, or the cell is in a process of its own"});
  // Held by the work, which may come later than anybody waits.
  auto answer = std::make_shared<Expected<Value>>(Value());
  const bool done = cell.on_unit([&cell, answer, work = std::move(work)] {
    if (auto worked = work(*cell.person()); !worked) {
      *answer = tl::unexpected(std::move(worked).error());
    } else {
      *answer = person_json(cell.world(), *cell.person());
    }
  });
  if (!done) return failed({ErrorCode::unavailable, "the cell does not answer"});
  return race::server::answer(std::move(*answer));
}

}  // namespace

Handled get_person(const Request&, Application& app) {
  return at_cell(app, [](world::Person&) { return Expected<void>(); });
}

Handled act_as_person(const Request& request, Application& app) {
  auto body = parse_json(request.body);
  if (!body) return failed(std::move(body).error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the act", errors);
  PersonAct act = read_person_act(fields, kClientPatience);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return at_cell(app, [act = std::move(act)](world::Person& person) { return perform(act, person); });
}

}  // namespace race::server
