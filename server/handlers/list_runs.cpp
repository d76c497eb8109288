// GET /api/v1/runs?document&before&limit: the newest runs first.
#include "server/handlers/runs.h"
#include "server/runs/run_json.h"

namespace race::server {

namespace {

constexpr std::uint64_t kMostListed = 100;

}  // namespace

Handled list_runs(const Request& request, Runs& runs) {
  const auto before = query_number(request, "before", 1, 0), limit = query_number(request, "limit", 1, kMostListed);
  if (!before) return failed(before.error());
  if (!limit) return failed(limit.error());
  if (*limit > kMostListed)
    return failed({ErrorCode::out_of_range, "at most " + std::to_string(kMostListed) + " runs at once", "limit"});
  const auto document = request.query.find("document");
  const auto found = runs.list(*before, *limit + 1, document == request.query.end() ? "" : document->second);
  if (!found) return failed(found.error());
  List list;
  for (const RunRecord& run : *found)
    if (list.size() < *limit) list.push_back(run_json(run));
  Dict json{{"runs", std::move(list)}};
  if (found->size() > *limit) json.set("next", static_cast<std::int64_t>((*found)[*limit - 1].id));
  return ok(std::move(json));
}

}  // namespace race::server
