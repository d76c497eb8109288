// GET /api/v1/health: the server answers, and what it hosts.
#include "server/handlers/handlers.h"

namespace race::server {

Handled get_health(const Request&, Application& app) {
  const auto documents = app.documents().list();
  if (!documents) return tl::unexpected(documents.error());
  const auto count = [](std::size_t n) { return Value(static_cast<std::int64_t>(n)); };
  return ok(Dict{{"status", "ok"},
                 {"version", kVersion},
                 {"time", app.cell().clock().now()},
                 {"documents", count(documents->size())},
                 {"cores", count(app.cores().all().size())},
                 {"services", count(app.cell().host().services().size())},
                 {"cell", app.cell().world() != nullptr}});
}

}  // namespace race::server
