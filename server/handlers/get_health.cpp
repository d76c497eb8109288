// GET /api/v1/health: the server answers. It asks nothing that may take long, so monitors may ask often.
#include "server/cell/cell.h"
#include "server/handlers/handlers.h"
#include "server/wire/calendar.h"
#include "server/wire/version.h"

namespace race::server {

namespace {

const std::int64_t kStarted = now_ms();

}  // namespace

Handled get_health(const Request&, Cell& cell) {
  return ok(Dict{{"status", "ok"},
                 {"version", version()},
                 {"time", cell.clock().now()},
                 {"started", kStarted},
                 {"cell", cell.world() != nullptr}});
}

}  // namespace race::server
