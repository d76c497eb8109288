#include "core/semantics/context.h"

namespace race::semantics {

RunState::RunState(const Program& program)
    : values(program.initial),
      flags(program.flag_count(), 0),
      arrived(program.ports.size(), 0),
      live(program.states.size()),
      arrivals(program.barriers.size(), 0),
      hot(program.states.size()),
      event_data(program.services.events().size(), Value::unknown()),
      event_tick(program.services.events().size(), 0),
      response_tick(program.services.operations().size(), 0),
      executed(program.actions.size(), 0),
      served(program.actions.size(), 0),
      triggered(program.ports.size(), 0),
      calls(program.services.operations().size()) {}

namespace {

// OPTIMIZATION: from the root along active children into whose subtree readers are, or, if the readers are few,
// straight to them.
void wake_below(RunState& run, const Program& program, StateId s, std::uint64_t mask) {
  const StateInfo& info = program[s];
  if (info.own_mask & mask) wake(run, s);
  for (StateId c = run.live[index(s)].first_active; c != kNoState; c = run.live[index(c)].next)
    if (program[c].subtree_mask & mask) wake_below(run, program, c, mask);
}

void wake_readers(RunState& run, const Program& program, const std::vector<StateId>& readers, std::uint64_t mask) {
  if (readers.size() > 8 * run.active_states) return wake_below(run, program, Program::root, mask);
  for (const StateId s : readers)
    if (run.flags[program.flag(s)]) wake(run, s);
}

}  // namespace

void wake_event_readers(RunState& run, const Program& program, EventId event) {
  wake_readers(run, program, program.event_readers[event], Program::event_bit(event));
}

void wake_response_readers(RunState& run, const Program& program, OperationId operation) {
  wake_readers(run, program, program.response_readers[operation], Program::response_bit(operation));
}

namespace {

void reset_range(RunState& run, const Program& program, Slot slot, std::size_t count, ValueLog& log) {
  for (const Slot end = slot + static_cast<Slot>(count); slot != end; ++slot) {
    if (run.values[slot].identical(program.initial[slot])) continue;
    log.emplace_back(slot, std::move(run.values[slot]));
    run.values[slot] = program.initial[slot];
  }
}

void reset_descendant(RunState& run, const Program& program, StateId s, ValueLog& log) {
  const StateInfo& info = program[s];
  reset_range(run, program, info.parameter_slot, info.parameters.size(), log);
  run.live[index(s)].touched = false;
  reset_values(run, program, s, log);
}

}  // namespace

void reset_values(RunState& run, const Program& program, StateId s, ValueLog& log) {
  const StateInfo& info = program[s];
  reset_range(run, program, info.result_slot, info.results.size(), log);
  reset_range(run, program, info.variable_slot, info.variables.size(), log);
  // OPTIMIZATION: only children that have been active since the last reset can have anything to reset.
  std::vector<StateId>& touched = run.live[index(s)].touched_children;
  for (const StateId child : touched) reset_descendant(run, program, child, log);
  touched.clear();
}

}  // namespace race::semantics
