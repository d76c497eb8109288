// POST /api/v1/cell/reset: the cell as it was at the start, and its database unless the body says `"database": false`.
#include "core/value/json.h"
#include "server/cell/cell.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"

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

void reset_cell(const Request& request, Respond respond, Cell& cell, Cores& cores, Deadlines& deadlines) {
  if (const auto world = world_of(cell); !world) return respond(tl::unexpected(world.error()));
  const auto with_database = read_with_database(request.body);
  if (!with_database) return respond(tl::unexpected(with_database.error()));
  if (auto idle = check_idle(cores); !idle) return respond(failed(std::move(idle).error()));
  cell.reset(*with_database, deadlines, answer_to(std::move(respond)));
}

}  // namespace race::server
