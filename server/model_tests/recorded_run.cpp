#include "server/model_tests/recorded_run.h"

#include <utility>
#include <vector>

namespace race::server {
namespace {

constexpr double kMicroseconds = 1e6;  // in a second

// Of each macro step; none if one is not known.
std::vector<double> times_of(const std::vector<TimingBlock>& blocks, std::size_t steps) {
  std::vector<double> times;
  for (const TimingBlock& block : blocks) {
    if (!block.steps.empty() && block.first != times.size() + 1) return {};
    for (const StepTime& step : block.steps) times.push_back(static_cast<double>(step.time) / kMicroseconds);
  }
  if (times.size() < steps) return {};
  return times;
}

}  // namespace

RecordedRun recorded_run(RunFile file) {
  auto times = times_of(file.timing, file.journal.entries.size());
  return {std::move(file.journal), std::move(times), std::move(file.services)};
}

Expected<RecordedRun> recorded_run(RunId id, Runs& runs) {
  ASSIGN_OR_RETURN(const RunRecord record, runs.get(id));
  RecordedRun run;
  ASSIGN_OR_RETURN(run.journal, journal_of(record, runs));
  ASSIGN_OR_RETURN(run.services, services_of(id, runs));
  ASSIGN_OR_RETURN(const auto timing, timing_of(id, runs));
  run.times = times_of(timing, run.journal.entries.size());
  return run;
}

}  // namespace race::server
