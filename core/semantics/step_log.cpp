#include "core/semantics/step_log.h"

#include <ranges>

namespace race::semantics {

void StepLog::undo(RunState& run) {
  for (auto& [at, value] : std::views::reverse(values)) run.values[at] = std::move(value);
  for (const auto& [flag, value] : std::views::reverse(flags)) run.flags[flag] = value;
  for (const auto& [port, value] : std::views::reverse(arrived)) run.arrived[index(port)] = value;
  for (const auto& [port, value] : std::views::reverse(triggered)) run.triggered[index(port)] = value;
  for (LoggedCall& call : std::views::reverse(calls)) {
    --run.call_count;
    std::vector<CallRecord>& records = run.calls[call.operation];
    records.pop_back();
    if (call.before) records.insert(records.begin() + static_cast<std::ptrdiff_t>(call.place), std::move(*call.before));
  }
  clear();
}

}  // namespace race::semantics
