#include "core/execution/replay.h"

#include "core/execution/step_json.h"

namespace race::execution {

namespace {

constexpr Recording kNothing{.entry = false};

}  // namespace

// The execution after the first `position` entries.
Expected<Execution> Replay::after(const std::vector<JournalEntry>& entries, std::size_t position) {
  const auto next = checkpoints_.upper_bound(position);
  auto execution = next == checkpoints_.begin() ? Execution::create(header_.program, header_.arguments, header_.budgets)
                                                : Expected<Execution>(std::prev(next)->second);
  if (!execution) return execution;
  for (std::size_t done = execution->run().position(); done < position; ++done) {
    keep(*execution);
    if (auto step = execution->replay(entries[done], kNothing); !step) return tl::unexpected(std::move(step).error());
  }
  return execution;
}

// A checkpoint every `interval_` steps; when there are too many, every second one goes.
void Replay::keep(const Execution& execution) {
  const std::size_t position = execution.run().position();
  if (position == 0 || position % interval_ != 0) return;
  checkpoints_.try_emplace(position, execution);
  if (checkpoints_.size() <= most_) return;
  interval_ *= 2;
  std::erase_if(checkpoints_, [this](const auto& each) { return each.first % interval_ != 0; });
}

Expected<List> Replay::steps(const std::vector<JournalEntry>& entries, std::size_t from, std::size_t to, int micro) {
  ASSIGN_OR_RETURN(Execution execution, after(entries, from - 1));
  List steps;
  for (std::size_t step = from; step <= to; ++step) {
    const bool partial = step == entries.size() && micro >= 0;
    const std::uint32_t limit = partial ? static_cast<std::uint32_t>(micro) : Execution::kNoLimit;
    ASSIGN_OR_RETURN(const Progress* progress, execution.replay(entries[step - 1], {.derivation = true}, limit));
    Dict json = trace_step(*header_.program, *progress);
    json.set("state", execution.run().state_json());
    if (partial) json.set("complete", false);
    steps.push_back(std::move(json));
  }
  return steps;
}

Expected<Execution> Replay::before(const std::vector<JournalEntry>& entries, std::size_t step, int micro) {
  ASSIGN_OR_RETURN(Execution execution, after(entries, step - 1));
  if (auto done = execution.replay(entries[step - 1], kNothing, static_cast<std::uint32_t>(micro)); !done)
    return tl::unexpected(std::move(done).error());
  return execution;
}

Expected<Value> derive_journal(const Journal& journal) {
  const JournalHeader& header = journal.header;
  ASSIGN_OR_RETURN(Execution execution, Execution::create(header.program, header.arguments, header.budgets));
  List steps;
  for (const JournalEntry& entry : journal.entries) {
    const auto progress = execution.replay(entry, {.entry = false, .derivation = true});
    if (!progress)
      return unexpected(progress.error().code, progress.error().message, "entries/" + std::to_string(steps.size()));
    steps.push_back(derived_step(execution, **progress));
  }
  Dict document;
  document.set("steps", std::move(steps));
  set_status(execution.run(), document);
  return Value(std::move(document));
}

}  // namespace race::execution
