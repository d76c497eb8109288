// POST /api/v1/cell/reset: the cell as it was at the start, and its database unless the body says `"database": false`.
#include "server/cell/cell.h"
#include "server/execution/cores.h"
#include "server/handlers/body.h"
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

/// Whether the database is reset, too.
Checked<bool> read_with_database(const std::string& text) {
  if (text.empty()) return true;
  return read_body(text, [](Fields& fields) { return fields.boolean("database").value_or(true); });
}

}  // namespace

void reset_cell(const Request& request, Respond respond, Cell& cell, Cores& cores, Control& control,
                ManualControl& manual, Deadlines& deadlines) {
  if (const auto world = world_of(cell); !world) return respond(tl::unexpected(world.error()));
  const auto with_database = read_with_database(request.body);
  if (!with_database) return respond(tl::unexpected(with_database.error()));
  const auto number = control_of(request, manual);
  if (!number) return respond(failed(number.error()));
  if (auto may = control.may_reset_cell(*number); !may) return respond(failed(std::move(may).error()));
  if (auto idle = check_idle(cores); !idle) return respond(failed(std::move(idle).error()));
  cell.reset(*with_database, deadlines, answer_to(std::move(respond)));
}

}  // namespace race::server
