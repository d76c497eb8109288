#include "core/semantics/work_set.h"

namespace race::semantics {
namespace {

// OPTIMIZATION: from the root along active children into whose subtree readers are, or, if the readers are few,
// straight to them.
void mark_below(RunState& run, const Program& program, StateId s, std::uint64_t mask) {
  const StateInfo& info = program[s];
  if (info.own_mask & mask) mark_dirty(run, s);
  for (StateId c = run.live[index(s)].first_active; c != kNoState; c = run.live[index(c)].next)
    if (program[c].subtree_mask & mask) mark_below(run, program, c, mask);
}

void mark_readers(RunState& run, const Program& program, const std::vector<StateId>& readers, std::uint64_t mask) {
  if (readers.size() > 8 * run.active_states) return mark_below(run, program, Program::root, mask);
  for (const StateId s : readers)
    if (run.flags[program.flag(s)]) mark_dirty(run, s);
}

}  // namespace

void mark_event_readers(RunState& run, const Program& program, EventId event) {
  mark_readers(run, program, program.event_readers[event], Program::event_bit(event));
}

void mark_response_readers(RunState& run, const Program& program, OperationId operation) {
  mark_readers(run, program, program.response_readers[operation], Program::response_bit(operation));
}

}  // namespace race::semantics
