#include "core/semantics/carry_over.h"

#include <algorithm>

namespace race::semantics {

std::vector<Obstacle> lost_nodes(const Program& before, const RunState& run, const Correspondence& same) {
  std::vector<std::uint8_t> states(before.states.size(), 0), barriers(before.barriers.size(), 0);
  for (const std::uint32_t s : same.states)
    if (s != kNone) states[s] = 1;
  for (const std::uint32_t b : same.barriers)
    if (b != kNone) barriers[b] = 1;
  std::vector<Obstacle> lost;
  for (std::uint32_t s = 0; s < before.states.size(); ++s) {
    const StateId parent = before[StateId{s}].parent;
    const bool outermost = parent == kNoState || states[index(parent)] != 0;
    if (run.flags[before.flag(StateId{s})] && !states[s] && outermost)
      lost.push_back({Obstacle::Kind::active, before[StateId{s}].path, before.id(StateId{s})});
  }
  for (std::uint32_t b = 0; b < before.barriers.size(); ++b)
    if (run.flags[before.flag(BarrierId{b})] && !barriers[b] && states[index(before[BarrierId{b}].parent)])
      lost.push_back({Obstacle::Kind::active, before[BarrierId{b}].path, before.id(BarrierId{b})});
  return lost;
}

namespace {

class CarryOver {
 public:
  CarryOver(const Program& before, const RunState& run, const Program& after, const Correspondence& same)
      : old_(before), from_(run), new_(after), same_(same), to_(after) {}

  RunState carry() {
    carry_stamps();
    carry_events();
    carry_calls();
    carry_values();
    for (std::uint32_t b = 0; b < new_.barriers.size(); ++b)
      if (same_.barriers[b] != kNone)
        to_.flags[new_.flag(BarrierId{b})] = from_.flags[old_.flag(BarrierId{same_.barriers[b]})];
    for (std::uint32_t s = 0; s < new_.states.size(); ++s) {
      if (same_.states[s] == kNone) continue;
      carry_state(StateId{s}, StateId{same_.states[s]});
      for (const PortId p : new_[StateId{s}].ports)
        if (same_.port(p) != kNoPort) carry_port(p, same_.port(p));
      for (const ActionId a : new_[StateId{s}].actions) carry_action(StateId{s}, a);
    }
    return std::move(to_);
  }

 private:
  void carry_stamps() {
    to_.small_budget = from_.small_budget;
    to_.epoch = from_.epoch + 1;  // `executed`, `triggered` and the states activated in this macro step are empty
    to_.tick = from_.tick;
    to_.transitions = from_.transitions;
    to_.call_count = from_.call_count;
    to_.started = from_.started;
    to_.services_called = from_.services_called;
  }

  void carry_events() {
    const auto& events = new_.services.events();
    for (EventId e = 0; e < events.size(); ++e) {
      const EventId before = old_.services.find_event(events[e].service, events[e].name);
      if (before == kNone || !new_.names_event(e)) continue;
      to_.event_data[e] = from_.event_data[before];
      to_.event_tick[e] = from_.event_tick[before];
    }
  }

  // R6, R20: "by (caller, S, op)". What an open operation stood for may have an entry of its own now; the
  // delivery stays with the open one, which all code that could have waited for it mentions (R19).
  void carry_calls() {
    std::vector<StateId> callers(old_.states.size(), kNoState);
    for (std::uint32_t s = 0; s < new_.states.size(); ++s)
      if (same_.states[s] != kNone) callers[same_.states[s]] = StateId{s};
    const auto& operations = old_.services.operations();
    for (OperationId o = 0; o < operations.size(); ++o) {
      for (const CallRecord& record : from_.calls[o])
        carry_call(callers, operations[o].open ? record.service : operations[o].service, operations[o].name, record);
      const OperationId after = operations[o].open
                                    ? open_operation(operations[o].name)
                                    : new_.services.dynamic_operation(operations[o].service, operations[o].name);
      if (after != kNone) to_.response_tick[after] = std::max(to_.response_tick[after], from_.response_tick[o]);
    }
    for (std::vector<CallRecord>& records : to_.calls) std::ranges::sort(records, {}, &CallRecord::number);
  }
  OperationId open_operation(const std::string& name) const {
    const auto& operations = new_.services.operations();
    const auto found =
        std::ranges::find_if(operations, [&](const auto& each) { return each.open && each.name == name; });
    return found == operations.end() ? kNone : static_cast<OperationId>(found - operations.begin());
  }
  void carry_call(const std::vector<StateId>& callers, const std::string& service, const std::string& name,
                  const CallRecord& record) {
    const OperationId o = new_.services.dynamic_operation(service, name);
    if (o == kNone || callers[index(record.caller)] == kNoState) return;
    CallRecord carried = record;
    carried.caller = callers[index(record.caller)];
    carried.service = new_.services.is_open(o) ? service : "";
    to_.calls[o].push_back(std::move(carried));
  }

  // What has no value yet gets the initial one, as if it were new.
  void carry_values() {
    for (ValueIndex at = 0; at < to_.values.size(); ++at)
      if (same_.values[at] != kNone && !from_.values[same_.values[at]].is_unknown())
        to_.values[at] = from_.values[same_.values[at]];
  }

  void carry_state(StateId s, StateId before) {
    to_.flags[new_.flag(s)] = from_.flags[old_.flag(before)];
    const Live& live = from_.live[index(before)];
    Live& carried = to_.live[index(s)];
    carried.activated_in = live.activated_in;
    carried.activated_at = live.activated_at;
    carried.calls_before = live.calls_before;
    carried.activations = live.activations;
    carried.life = live.life;
    carried.resolved_in = live.resolved_in;
    if (new_[s].keeps && new_[s].parent != kNoState) carry_leaving(s, live, carried);
  }

  // R8, R26: how the state was left.
  void carry_leaving(StateId s, const Live& live, Live& carried) {
    if (live.left_through == kNoPort) {
      if (new_[s].keeps_deep) carried.left_during = live.left_during;
      return;
    }
    for (const PortId p : new_[s].ports) {
      if (same_.port(p) != live.left_through) continue;
      carried.left_through = p;
      carried.left_during = live.left_during;
    }
  }

  void carry_port(PortId p, PortId before) {
    to_.flags[new_.flag(p)] = from_.flags[old_.flag(before)];
    if (!from_.arrived[index(before)]) return;
    const NodeRef to = new_[p].to, to_before = old_[before].to;
    if (to.barrier && to_before && same_.barriers[to.number] == to_before.number) to_.arrived[index(p)] = 1;
  }

  // REFINEMENT R19: "a new or changed action that contains `svc` as R19 says starts, in an active state, as served, so
  // that no old datum commands anything".
  void carry_action(StateId s, ActionId a) {
    if (same_.actions[a] != kNone) {
      to_.executed[a] = from_.executed[same_.actions[a]];
      to_.served[a] = from_.served[same_.actions[a]];
    } else if (new_.actions[a].served && to_.flags[new_.flag(s)]) {
      to_.served[a] = ++to_.tick;
    }
  }

  const Program& old_;
  const RunState& from_;
  const Program& new_;
  const Correspondence& same_;
  RunState to_;
};

}  // namespace

RunState carried_state(const Program& before, const RunState& run, const Program& after, const Correspondence& same) {
  return CarryOver(before, run, after, same).carry();
}

void open_complete_barriers(const Program& program, RunState& run) {
  for (std::uint32_t number = 0; number < program.barriers.size(); ++number) {
    const BarrierId b{number};
    const auto& in = program[b].in;
    if (in.empty() || !std::ranges::all_of(in, [&](PortId p) { return run.arrived[index(p)] != 0; })) continue;
    run.flags[program.flag(b)] = 1;
  }
}

}  // namespace race::semantics
