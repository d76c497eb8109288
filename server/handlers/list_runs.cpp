// GET /api/v1/runs?document&before&limit: the newest runs first; damaged ones as errors.
#include "server/handlers/runs.h"
#include "server/runs/run_json.h"
#include "server/wire/errors.h"

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
  const auto found = runs.list(*before, *limit, document == request.query.end() ? "" : document->second);
  if (!found) return failed(found.error());
  List list;
  for (const RunRecord& run : found->runs) list.push_back(run_json(run));
  Dict json{{"runs", std::move(list)}};
  if (found->next) json.set("next", static_cast<std::int64_t>(*found->next));
  if (const std::vector<Error> damaged = found->errors(); !damaged.empty())
    json.set("damaged", *errors_json(damaged).find("errors"));
  return ok(std::move(json));
}

}  // namespace race::server
