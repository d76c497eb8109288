#include "core/semantics/context.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/semantics/work_set.h"

namespace race::semantics {

RunState::RunState(const Program& program)
    : values(program.initial),
      flags(program.flag_count(), 0),
      arrived(program.ports.size(), 0),
      live(program.states.size()),
      arrivals(program.barriers.size(), 0),
      work_set(program.states.size()),
      value_units(program.initial_units),
      data_units(std::accumulate(value_units.begin(), value_units.end(), std::uint64_t{0})),
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

void append_active_child(RunState& run, StateId s, StateId parent) {
  Live& above = run.live[index(parent)];
  run.live[index(s)].previous = above.last_active;
  (above.last_active == kNoState ? above.first_active : run.live[index(above.last_active)].next) = s;
  above.last_active = s;
}

void list_port(RunState& run, const Program& program, PortId p) {
  const PortInfo& info = program[p];
  if (run.arrived[index(p)]) ++run.arrivals[info.to.number];
  const StateId parent = program[info.state].parent;
  if (!run.flags[program.flag(p)] || parent == kNoState) return;
  Live& above = run.live[index(parent)];
  (info.to ? above.active_ports : above.unconnected_ports).push_back(p);
}

void list_barrier(RunState& run, const Program& program, BarrierId b) {
  Live& above = run.live[index(program[b].parent)];
  if (run.flags[program.flag(b)]) above.active_barriers.push_back(b);
  if (run.arrivals[index(b)] > 0) above.partial_barriers.push_back(b);
}

// Whether `s` has anything that reset_values has to reset. Requires the same of its children.
bool is_touched(const RunState& run, const Program& program, StateId s) {
  const StateInfo& info = program[s];
  if (run.flags[program.flag(s)] || !run.live[index(s)].touched_children.empty()) return true;
  const std::size_t count = info.parameters.size() + info.results.size() + info.variables.size();
  for (std::size_t at = info.first_parameter; at < info.first_parameter + count; ++at)
    if (!run.values[at].identical(program.initial[at])) return true;
  return false;
}

}  // namespace

void count_data(RunState& run, const ValueLog& log, std::vector<ValueIndex>& changed) {
  changed.clear();
  for (const auto& [at, before] : log)
    if (holds_data(before) || holds_data(run.values[at])) changed.push_back(at);
  std::ranges::sort(changed);
  const auto repeated = std::ranges::unique(changed);
  changed.erase(repeated.begin(), repeated.end());
  for (const ValueIndex at : changed) {
    const Value& now = run.values[at];
    const std::uint32_t units = data_units(now);
    run.data_units += units;
    run.data_units -= std::exchange(run.value_units[at], units);
  }
}

void fill_lists(RunState& run, const Program& program) {
  run.data_units = 0;
  for (std::size_t at = 0; at < run.values.size(); ++at) {
    run.value_units[at] = data_units(run.values[at]);
    run.data_units += run.value_units[at];
  }
  for (std::uint32_t number = 0; number < program.states.size(); ++number) {
    const StateId s{number}, parent = program[s].parent;
    if (!run.flags[program.flag(s)]) continue;
    ++run.active_states;
    if (parent != kNoState) append_active_child(run, s, parent);
    mark_dirty(run, s);
  }
  for (std::uint32_t number = 0; number < program.ports.size(); ++number) list_port(run, program, PortId{number});
  for (std::uint32_t number = 0; number < program.barriers.size(); ++number)
    list_barrier(run, program, BarrierId{number});
  for (auto number = static_cast<std::uint32_t>(program.states.size()); number-- > 1;) {
    const StateId s{number};
    run.live[number].touched = is_touched(run, program, s);
    if (run.live[number].touched) run.live[index(program[s].parent)].touched_children.push_back(s);
  }
}

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
