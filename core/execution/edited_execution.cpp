// An execution whose model is edited, or that is told something from outside (core/SEMANTICS.md section 9).
#include <cassert>

#include "core/execution/execution.h"

namespace race::execution {

using semantics::Run;

tl::expected<const Progress*, std::vector<semantics::Obstacle>> Execution::edit(EditEntry entry, ExecutedModel model,
                                                                                Recording recording,
                                                                                std::uint32_t limit) {
  assert(!open_ && !is_over() && run_.position() > 0);
  auto run = run_.edited(model.program);
  if (!run) return tl::unexpected(std::move(run).error());
  model_ = std::move(model);
  is_edited_ = true;
  const Progress& progress =
      begin_with(std::move(*run), recording.entry ? std::optional<JournalEntry>(std::move(entry)) : std::nullopt,
                 recording, limit);
  progress_.edited = true;
  return &progress;
}

Expected<const Progress*> Execution::force(const semantics::Force& force, Recording recording, std::uint32_t limit) {
  assert(!open_ && !is_over());
  if (run_.position() == 0) return unexpected(ErrorCode::conflict, "the run has not begun");
  ASSIGN_OR_RETURN(Run run, run_.forced(force));
  return &begin_with(std::move(run), recording.entry ? std::optional<JournalEntry>(ForceEntry{force}) : std::nullopt,
                     recording, limit);
}

Expected<const Progress*> Execution::replay_edit(const EditEntry& entry, Recording recording, std::uint32_t limit) {
  if (run_.position() == 0) return unexpected(ErrorCode::conflict, "the run has not begun");
  auto model = edited(model_, entry);
  if (!model)
    return unexpected(ErrorCode::conflict, "the edit does not fit the model: " + to_string(model.error().front()));
  auto progress = edit(entry, std::move(*model), recording, limit);
  if (progress) return *progress;
  return unexpected(ErrorCode::conflict,
                    "the edit waits for " + progress.error().front().path + " here: the journal is of another run");
}

// `run` is the one that there was, at the beginning of a macro step.
const Progress& Execution::begin_with(Run&& run, std::optional<JournalEntry> entry, Recording recording,
                                      std::uint32_t limit) {
  waiting_.carry_over(run_, run);
  Run before = std::exchange(run_, std::move(run));
  carry_goals(before);
  if (&before.program() != &run_.program()) {
    order_ = semantics::Order::declared();
    if (view_) view_->snapshot(run_);
  }
  open_ = true;
  recording_ = recording;
  progress_.untold = false;
  progress_.entry = std::move(entry);
  progress_.position = run_.position();
  progress_.micro = 0;
  progress_.begins = true;
  return do_part(limit);
}

// A goal that the model does not have any more is given up: the execution stops after this macro step, as at one that
// is reached.
void Execution::carry_goals(const Run& before) {
  if (&before.program() == &run_.program()) return;
  const semantics::Correspondence same(before.program(), run_.program());
  if (goal_ && !goal_->carry_over(same, run_.program())) set_goal(Goal{.kind = Goal::Kind::macro});
  std::erase_if(breakpoints_, [&](GoalWatch& breakpoint) { return !breakpoint.carry_over(same, run_.program()); });
}

}  // namespace race::execution
