#include "core/execution/replay.h"

#include <algorithm>

#include "core/execution/checkpoint.h"
#include "core/execution/step_json.h"

namespace race::execution {

namespace {

constexpr Recording kNothing{.entry = false};
}  // namespace

// The nearest execution at or before `position`: one that was kept, a stored checkpoint, or the beginning.
Expected<Execution> Replay::nearest(std::uint64_t position) {
  const auto next = checkpoints_.upper_bound(position);
  const std::uint64_t kept = next == checkpoints_.begin() ? 0 : std::prev(next)->first;
  if (position - kept > interval_) {
    // One that cannot be read costs time, not the run.
    const auto stored = source_->checkpoint(position);
    auto execution = stored && !stored->is_unknown() ? read_checkpoint(header_, *stored)
                                                     : Expected<Execution>(tl::unexpect, Error{});
    if (execution && execution->run().position() > kept) {
      execution->drop_waiting();
      return execution;
    }
  }
  if (kept > 0) return std::prev(next)->second;
  return Execution::create(header_);
}

Expected<Execution> Replay::after(std::uint64_t position, const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(Execution execution, nearest(position));
  execution.stop_with(stop);
  while (execution.run().position() < position) {
    const std::uint64_t from = execution.run().position() + 1, to = std::min(position, from + kEntriesAtOnce - 1);
    ASSIGN_OR_RETURN(const std::vector<JournalEntry> entries, source_->entries(from, to));
    for (const JournalEntry& entry : entries) {
      keep(execution);
      if (auto step = execution.replay(entry, kNothing); !step) return tl::unexpected(std::move(step).error());
    }
  }
  return execution;
}

Expected<Execution> Replay::next(Execution before, const std::atomic<bool>* stop) {
  before.stop_with(stop);
  const std::uint64_t position = before.run().position() + 1;
  ASSIGN_OR_RETURN(const std::vector<JournalEntry> entries, source_->entries(position, position));
  if (auto step = before.replay(entries.front(), kNothing); !step) return tl::unexpected(std::move(step).error());
  return before;
}

void Replay::keep(const Execution& execution) {
  const std::size_t position = execution.run().position();
  if (position == 0 || position % interval_ != 0) return;
  checkpoints_.try_emplace(position, execution).first->second.stop_with(nullptr);
  if (checkpoints_.size() <= most_) return;
  interval_ *= 2;
  std::erase_if(checkpoints_, [this](const auto& each) { return each.first % interval_ != 0; });
}

Expected<List> Replay::steps(std::uint64_t from, std::uint64_t to, std::uint64_t last, int micro,
                             const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(Execution execution, after(from - 1, stop));
  ASSIGN_OR_RETURN(const std::vector<JournalEntry> entries, source_->entries(from, to));
  List steps;
  for (std::uint64_t step = from; step <= to; ++step) {
    const bool partial = step == last && micro >= 0;
    const std::uint32_t limit = partial ? static_cast<std::uint32_t>(micro) : Execution::kNoLimit;
    ASSIGN_OR_RETURN(const Progress* progress, execution.replay(entries[step - from], {.derivation = true}, limit));
    Dict json = trace_step(execution.run().program(), *progress);
    json.set("state", execution.run().state_json());
    if (partial) json.set("complete", false);
    steps.push_back(std::move(json));
  }
  return steps;
}

Expected<Execution> Replay::before(std::uint64_t step, int micro, const std::atomic<bool>* stop) {
  ASSIGN_OR_RETURN(Execution execution, after(step - 1, stop));
  ASSIGN_OR_RETURN(const std::vector<JournalEntry> entries, source_->entries(step, step));
  if (auto done = execution.replay(entries.front(), kNothing, static_cast<std::uint32_t>(micro)); !done)
    return tl::unexpected(std::move(done).error());
  return execution;
}

}  // namespace race::execution
