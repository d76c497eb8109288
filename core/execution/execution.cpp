#include "core/execution/execution.h"

#include <cassert>

#include "core/execution/journal_input.h"

namespace race::execution {

using semantics::Input;
using semantics::Run;

Expected<Execution> Execution::create(std::shared_ptr<const semantics::Program> program, const Dict& arguments,
                                      semantics::Budgets budgets) {
  ASSIGN_OR_RETURN(Run run, Run::create(std::move(program), arguments, budgets));
  return Execution(std::move(run));
}

Expected<Execution> Execution::create(const JournalHeader& header) {
  ASSIGN_OR_RETURN(Execution execution, create(header.program, header.arguments, header.budgets));
  execution.model_ = {header.native, header.program, 0};
  return execution;
}

inline const Progress& Execution::finish() {
  progress_.untold = open_ && recording_.whole && !progress_.reached_goal;
  return progress_.untold ? progress_ : tell_part();
}

// What has come of the micro steps leaves the run.
const Progress& Execution::tell_part() {
  progress_.untold = false;
  run_.take_output(progress_.calls, progress_.printed);
  for (std::string& text : progress_.printed)
    if (text.ends_with('\n')) text.pop_back();
  if (view_) progress_.delta = view_->delta(run_);
  progress_.complete = !open_;
  if (open_) return progress_;
  if (goal_ && goal_->goal().kind == Goal::Kind::macro) {
    goal_.reset();
    progress_.reached_goal = true;
  }
  if (is_over()) {
    goal_.reset();
    waiting_.clear();
  }
  return progress_;
}

const Progress& Execution::start(Recording recording, std::uint32_t limit) {
  assert(run_.position() == 0);
  progress_.entry.reset();
  if (recording.entry) progress_.entry = StartEntry{};
  return begin(std::nullopt, recording, limit);
}

const Progress& Execution::step(Recording recording, std::uint32_t limit) {
  std::optional<Input> input = waiting_.take(run_);
  progress_.entry.reset();
  if (recording.entry && input) progress_.entry = entry_of(run_, *input);
  return begin(std::move(input), recording, limit);
}

Expected<const Progress*> Execution::replay(const JournalEntry& entry, Recording recording, std::uint32_t limit) {
  auto progress = replay_entry(entry, recording, limit);
  if (run_.is_told_to_stop()) return unexpected(ErrorCode::unavailable, "nobody waits for the replay any more");
  return progress;
}

Expected<const Progress*> Execution::replay_entry(const JournalEntry& entry, Recording recording, std::uint32_t limit) {
  if (is_over()) return unexpected(ErrorCode::conflict, "the run is over before this entry");
  if (std::holds_alternative<AbortEntry>(entry)) return &abort();
  // core/SEMANTICS.md section 10: the first entry is `start`, or `abort` if the run was aborted before it began.
  if (std::holds_alternative<StartEntry>(entry) != (run_.position() == 0))
    return unexpected(ErrorCode::conflict, "a run begins with `start`, and only begins with it");
  if (std::holds_alternative<StartEntry>(entry)) return &start(recording, limit);
  if (const auto* edited = std::get_if<EditEntry>(&entry)) return replay_edit(*edited, recording, limit);
  if (const auto* forced = std::get_if<ForceEntry>(&entry)) return force(forced->force, recording, limit);
  ASSIGN_OR_RETURN(Input input, input_of(run_, entry));
  if (recording.entry)
    progress_.entry = entry;
  else
    progress_.entry.reset();
  return &begin(std::move(input), recording, limit);
}

const Progress& Execution::abort() {
  assert(!open_);
  run_.abort();
  progress_ = {.position = run_.position(), .entry = AbortEntry{}, .begins = true};
  return finish();
}

void Execution::set_goal(std::optional<Goal> goal) {
  goal_.reset();
  if (goal) goal_.emplace(*goal, run_);
}

// One that stays does not stop before the same micro step again.
void Execution::set_breakpoints(const std::vector<Goal>& goals) {
  const std::vector<GoalWatch> before = std::exchange(breakpoints_, {});
  for (const Goal& goal : goals) {
    GoalWatch& breakpoint = breakpoints_.emplace_back(goal, run_);
    const auto same = std::ranges::find(before, goal, &GoalWatch::goal);
    if (same != before.end()) breakpoint.take_stop(*same);
  }
}

Value Execution::watch() {
  if (!view_) view_.emplace();
  return view_->snapshot(run_);
}

const Progress& Execution::begin(std::optional<Input>&& input, Recording recording, std::uint32_t limit) {
  assert(!open_ && !is_over());
  open_ = true;
  recording_ = recording;
  progress_.untold = false;
  run_.begin(std::move(input));
  progress_.position = run_.position();
  progress_.micro = 0;
  progress_.begins = true;
  return do_part(limit);
}

inline void Execution::begin_part() {
  progress_.complete = progress_.reached_goal = false;
  progress_.breakpoints.clear();
  if (progress_.untold) return;  // it is one with those before
  progress_.first = progress_.micro;
  progress_.edited = false;
  progress_.derivation.reset();
}

const Progress& Execution::continue_step(std::uint32_t limit) {
  assert(open_ && (limit > 0 || progress_.micro == 0));
  // Each entry is one macro step (core/SEMANTICS.md, section 10): one that was held before its first micro step has
  // told its entry with no micro step done.
  if (!progress_.untold) progress_.begins = false;
  return do_part(limit);
}

const Progress& Execution::do_part(std::uint32_t limit) {
  begin_part();
  if (recording_.derivation) {
    semantics::TreeRecorder trees;
    if (progress_.derivation) trees.derivation = std::move(*progress_.derivation);
    needs_facts() ? do_watched_micro_steps(trees, limit) : do_micro_steps(trees, limit);
    progress_.derivation = std::move(trees.derivation);
  } else if (needs_facts()) {
    semantics::TreeRecorder trees;
    do_watched_micro_steps(trees, limit);
  } else if (order_.is_declared() && run_.state().forced == semantics::kNoPort) {
    semantics::NoRecorder none;
    do_micro_steps(none, limit);
  } else {  // a recorder that visits all, as another order requires, and a forced port
    semantics::NameRecorder names;
    do_micro_steps(names, limit);
  }
  return finish();
}

template <semantics::Recorder R>
void Execution::do_micro_steps(R& recorder, std::uint32_t limit) {
  open_ = !run_.quiesce(recorder, order_, limit, [this] {
    note_micro_step();
    return goes_on_after(nullptr);
  });
}

void Execution::note_micro_step() {
  ++progress_.micro;
  if (view_) view_->note_fired_ports(run_);
}

// Whether the macro step goes on after a micro step.
bool Execution::goes_on_after(const MicroStepFacts* facts) {
  if (goal_ || !breakpoints_.empty())
    progress_.reached_goal = any_goal([&](GoalWatch& goal) { return goal.reached(run_, facts); });
  return !progress_.reached_goal;
}

}  // namespace race::execution
