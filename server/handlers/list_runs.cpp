// GET /api/v1/runs?document&before&limit: the newest runs first; damaged ones as errors.
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/run_json.h"
#include "server/wire/errors.h"

namespace race::server {

namespace {

constexpr std::int64_t kMostListed = 100;

}  // namespace

Handled list_runs(const Request& request, Runs& runs) {
  const auto before = query_number(request, "before"), limit = query_number(request, "limit", {1, kMostListed});
  if (!before) return failed(before.error());
  if (!limit) return failed(limit.error());
  const auto most = static_cast<std::uint64_t>(limit->value_or(kMostListed));
  const auto found = runs.list(static_cast<RunId>(before->value_or(0)), most, query_text(request, "document"));
  if (!found) return failed(found.error());
  List list;
  for (const RunRecord& run : found->runs) list.push_back(run_json(run));
  Dict json{{"runs", std::move(list)}};
  if (found->next) json.set("next", static_cast<std::int64_t>(*found->next));
  if (const std::vector<Error> damaged = found->errors(); !damaged.empty()) json.set("damaged", error_list(damaged));
  return ok(std::move(json));
}

}  // namespace race::server
