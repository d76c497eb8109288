// GET /api/v1/health: the server answers, and what it hosts.
#include "server/cell/cell.h"
#include "server/execution/cores.h"
#include "server/handlers/handlers.h"
#include "server/store/documents.h"
#include "server/wire/version.h"

namespace race::server {

Handled get_health(const Request&, Documents& documents, Cores& cores, Cell& cell) {
  const auto stored = documents.heads();
  if (!stored) return failed(stored.error());
  const auto count = [](std::size_t n) { return Value(static_cast<std::int64_t>(n)); };
  return ok(Dict{{"status", "ok"},
                 {"version", version()},
                 {"time", cell.clock().now()},
                 {"documents", count(stored->revisions.size())},
                 {"cores", count(cores.all().size())},
                 {"services", count(cell.host().services().size())},
                 {"cell", cell.world() != nullptr}});
}

}  // namespace race::server
