#include "server/runs/run_replay.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/execution/compare.h"
#include "core/execution/journal_walk.h"
#include "server/execution/past_json.h"
#include "server/runs/run_json.h"

namespace race::server {
namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

/// A run that stands before macro step `from`.
Expected<execution::JournalWalk> walk_from(Runs& runs, const RunRecord& run, std::uint64_t from,
                                           const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(execution::JournalHeader header, runs.header(run.id));
  const auto source = runs.source(run.id);
  execution::Replay replay(std::move(header), source);
  ASSIGN_OR_RETURN(execution::Execution execution, replay.after(from - 1, stop));
  return execution::JournalWalk(std::move(execution), source, run.steps);
}

/// Of a run of which there is macro step `step`; 0 is the last one, as `step` is then.
Expected<execution::Replay> replay_of(Runs& runs, RunId id, std::uint64_t& step) {
  ASSIGN_OR_RETURN(const RunRecord run, runs.get(id));
  if (step == 0) step = run.steps;
  if (step < 1 || step > run.steps)
    return unexpected(ErrorCode::out_of_range, "there are macro steps 1 to " + std::to_string(run.steps), "step");
  ASSIGN_OR_RETURN(execution::JournalHeader header, runs.header(id));
  return execution::Replay(std::move(header), runs.source(id));
}

}  // namespace

Expected<Value> run_derivations(Runs& runs, RunId id, std::uint64_t from, std::uint64_t to,
                                const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(const RunRecord run, runs.get(id));
  if (from == 0) from = run.steps;
  if (to == 0) to = from;
  if (run.steps > 0 && (from > to || to > run.steps || to - from >= kMostDerivations))
    return unexpected(ErrorCode::out_of_range, "macro steps 1 to " + std::to_string(run.steps) +
                                                   " can be had, at most " + std::to_string(kMostDerivations) +
                                                   " at once");
  Dict json;
  set_status(run, json);
  List steps;
  if (run.steps > 0) {
    ASSIGN_OR_RETURN(execution::JournalHeader header, runs.header(id));
    execution::Replay replay(std::move(header), runs.source(id));
    ASSIGN_OR_RETURN(steps, replay.steps(from, to, run.steps, -1, stop));
  }
  json.set("steps", std::move(steps));
  return Value(std::move(json));
}

Expected<Value> run_past(Runs& runs, RunId id, std::uint64_t step, int micro, const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(execution::Replay replay, replay_of(runs, id, step));
  return past_json(replay, step, micro, {runs, id, {}}, stop);
}

Expected<Value> run_why(Runs& runs, RunId id, const execution::WhyQuestion& question, std::uint64_t step, int micro,
                        const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(execution::Replay replay, replay_of(runs, id, step));
  return execution::why_before(replay, question, step, micro, stop);
}

Expected<Value> compare_runs(Runs& runs, RunId first, RunId second, std::uint64_t from, std::uint64_t most,
                             const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(const RunRecord a, runs.get(first));
  ASSIGN_OR_RETURN(const RunRecord b, runs.get(second));
  if (from == 0) from = 1;
  const std::uint64_t last = std::max(a.steps, b.steps);
  if (from > std::min(a.steps, b.steps) + 1)
    return unexpected(ErrorCode::out_of_range,
                      "both runs have macro steps 1 to " + std::to_string(std::min(a.steps, b.steps)), "from");
  ASSIGN_OR_RETURN(execution::JournalWalk one, walk_from(runs, a, from, stop));
  ASSIGN_OR_RETURN(execution::JournalWalk other, walk_from(runs, b, from, stop));
  ASSIGN_OR_RETURN(execution::Comparison comparison, execution::compare(one, other, most));
  Dict json{{"same", !comparison.difference.has_value()},
            {"steps", List{integer(a.steps), integer(b.steps)}},
            {"compared", integer(comparison.compared)}};
  if (comparison.difference) {
    json.set("step", integer(comparison.difference->step));
    if (comparison.difference->micro) json.set("micro", integer(*comparison.difference->micro));
    json.set("first", std::move(comparison.difference->first));
    json.set("second", std::move(comparison.difference->second));
  } else if (comparison.compared < last) {
    json.set("next", integer(comparison.compared + 1));
  }
  return Value(std::move(json));
}

}  // namespace race::server
