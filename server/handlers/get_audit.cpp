// GET /api/v1/audit?before&limit: who has changed what, the last first.
#include "server/accounts/audit_log.h"
#include "server/handlers/handlers.h"
#include "server/handlers/query.h"

namespace race::server {
namespace {

constexpr std::int64_t kMostListed = 1000;

}  // namespace

Handled get_audit(const Request& request, AuditLog& audit) {
  const auto before = query_number(request, "before"), limit = query_number(request, "limit", {1, kMostListed});
  if (!before) return failed(before.error());
  if (!limit) return failed(limit.error());
  const auto page = audit.list(*before, limit->value_or(kMostListed));
  if (!page) return failed(page.error());
  List list;
  for (const AuditEntry& entry : page->entries)
    list.push_back(Dict{{"number", entry.number},
                        {"time", entry.time},
                        {"account", entry.account},
                        {"address", entry.address},
                        {"action", entry.action},
                        {"outcome", entry.outcome}});
  Dict json{{"entries", std::move(list)}};
  if (page->next) json.set("next", *page->next);
  return ok(std::move(json));
}

}  // namespace race::server
