#include "core/semantics/context.h"

namespace race::semantics {

RunState::RunState(const Program& program)
    : values(program.initial),
      flags(program.flag_count(), 0),
      arrived(program.ports.size(), 0),
      live(program.states.size()),
      event_data(program.services.events().size(), Value::unknown()),
      event_tick(program.services.events().size(), 0),
      response_tick(program.services.operations().size(), 0),
      executed(program.actions.size(), 0),
      served(program.actions.size(), 0),
      triggered(program.ports.size(), 0),
      calls(program.services.operations().size()) {}

void wake_state(RunState& run, const Program& program, StateId s) {
  run.live[index(s)].dirty = true;
  for (; s != kNoState; s = program[s].parent) run.live[index(s)].awake = true;
}

bool wake_readers(RunState& run, const Program& program, StateId s, std::uint64_t mask) {
  const StateInfo& info = program[s];
  if (!(info.subtree_mask & mask)) return false;
  Live& live = run.live[index(s)];
  bool any = false;
  if (info.own_mask & mask) any = live.dirty = true;
  for (StateId c = live.first_active; c != kNoState; c = run.live[index(c)].next)
    if (wake_readers(run, program, c, mask)) any = true;
  if (any) live.awake = true;
  return any;
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
