// POST /api/v1/cell/reset: the cell as it was at the start, and its database unless the body says `"database": false`.
#include "core/value/json.h"
#include "server/cell/cell.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/handlers/supervision.h"

namespace race::server {
namespace {

/// Error `conflict`: a run has begun and is not over. What it calls is computed (`svc[...]`), so any may use the cell.
Expected<void> check_idle(const Cores& cores) {
  for (const auto& core : cores.all()) {
    const Value info = core->info();
    if (info.find("status")->as_string() == "ready" || is_over(info)) continue;
    return unexpected(ErrorCode::conflict, "run " + core->id() + " of " + info.find("document")->as_string() +
                                               " is not over; stop it before the cell is reset");
  }
  return {};
}

/// The arm is put where it was at the start: errors `stopped`; `leased`: somebody else has the controls.
Expected<void> check_free(const Control& control, std::uint64_t number) {
  if (const auto stop = control.stopped())
    return unexpected(ErrorCode::stopped, "the cell was stopped by " + stop->by + "; reset the stop first");
  if (const auto holder = control.holder(); holder != 0 && holder != number)
    return unexpected(ErrorCode::leased, "somebody else has the controls of the cell");
  return {};
}

/// Whether the database is reset, too.
Checked<bool> read_with_database(const std::string& text) {
  if (text.empty()) return true;
  const auto body = parse_json(text);
  if (!body) return failed(body.error());
  std::vector<Error> errors;
  Fields fields(*body, "", "the request", errors, Fields::Paths::field);
  const auto database = fields.boolean("database");
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return database.value_or(true);
}

}  // namespace

void reset_cell(const Request& request, Respond respond, Cell& cell, Cores& cores, Control& control,
                ManualControl& manual, Deadlines& deadlines) {
  if (const auto world = world_of(cell); !world) return respond(tl::unexpected(world.error()));
  const auto with_database = read_with_database(request.body);
  if (!with_database) return respond(tl::unexpected(with_database.error()));
  const auto number = control_of(request, manual);
  if (!number) return respond(failed(number.error()));
  if (auto free = check_free(control, *number); !free) return respond(failed(std::move(free).error()));
  if (auto idle = check_idle(cores); !idle) return respond(failed(std::move(idle).error()));
  cell.reset(*with_database, deadlines, answer_to(std::move(respond)));
}

}  // namespace race::server
