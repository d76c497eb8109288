// GET /api/v1/runs/{run}/timing?from&to: when macro steps began, inputs came and services had which states.
#include "server/execution/cores.h"
#include "server/handlers/query.h"
#include "server/handlers/runs.h"
#include "server/runs/timing_json.h"

namespace race::server {

namespace {

struct Range {
  std::uint64_t from, to;
};

/// The query's range, as far as the run goes; else the last macro steps.
Expected<Range> range_of(const Request& request, std::uint64_t steps) {
  ASSIGN_OR_RETURN(const auto from, query_number(request, "from"));
  ASSIGN_OR_RETURN(const auto to, query_number(request, "to"));
  const std::uint64_t last = to ? static_cast<std::uint64_t>(*to) : steps;
  const std::uint64_t first = from ? static_cast<std::uint64_t>(*from) : last - std::min(last, kMostTimes) + 1;
  if (steps > 0 && (first > last || last > steps || last - first >= kMostTimes))
    return unexpected(ErrorCode::out_of_range, "macro steps 1 to " + std::to_string(steps) + " can be had, at most " +
                                                   std::to_string(kMostTimes) + " at once");
  return Range{first, last};
}

}  // namespace

Handled get_run_timing(const Request& request, Runs& runs, Cores& cores) {
  std::vector<TimingBlock> recent;
  if (const auto core = cores.find(request.parameters.at("run"))) recent = (*core)->timing();
  const auto run = run_of(request, runs);
  if (!run) return failed(run.error());
  const auto range = range_of(request, run->steps);
  if (!range) return failed(range.error());
  const auto blocks = timing_blocks(runs, run->id, range->from, range->to, recent);
  if (!blocks) return failed(blocks.error());
  return ok(timing_json(*blocks, range->from, range->to));
}

}  // namespace race::server
