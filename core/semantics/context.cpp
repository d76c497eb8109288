#include "core/semantics/context.h"

namespace race::semantics {

RunState::RunState(const Program& program)
    : values(program.initial),
      flags(program.flag_count(), 0),
      arrived(program.ports.size(), 0),
      live(program.states.size()),
      arrivals(program.barriers.size(), 0),
      work_set(program.states.size()),
      event_data(program.services.events().size(), Value::unknown()),
      event_tick(program.services.events().size(), 0),
      response_tick(program.services.operations().size(), 0),
      executed(program.actions.size(), 0),
      served(program.actions.size(), 0),
      triggered(program.ports.size(), 0),
      calls(program.services.operations().size()) {}

namespace {

void reset_range(RunState& run, const Program& program, ValueIndex at, std::size_t count, ValueLog& log) {
  for (const ValueIndex end = at + static_cast<ValueIndex>(count); at != end; ++at) {
    if (run.values[at].identical(program.initial[at])) continue;
    log.emplace_back(at, std::move(run.values[at]));
    run.values[at] = program.initial[at];
  }
}

void reset_descendant(RunState& run, const Program& program, StateId s, ValueLog& log) {
  const StateInfo& info = program[s];
  reset_range(run, program, info.first_parameter, info.parameters.size(), log);
  run.live[index(s)].touched = false;
  reset_values(run, program, s, log);
}

}  // namespace

void reset_values(RunState& run, const Program& program, StateId s, ValueLog& log) {
  const StateInfo& info = program[s];
  reset_range(run, program, info.first_result, info.results.size(), log);
  reset_range(run, program, info.first_variable, info.variables.size(), log);
  // OPTIMIZATION: only children that have been active since the last reset can have anything to reset.
  std::vector<StateId>& touched = run.live[index(s)].touched_children;
  for (const StateId child : touched) reset_descendant(run, program, child, log);
  touched.clear();
}

}  // namespace race::semantics
