// StepContext: Σ and Δ as the rules of one micro step read and change them. Every change goes to the log that can undo
// it, keeps the lists of active children and marks the states that read what has changed (work_set.h).
#pragma once

#include <algorithm>

#include "core/semantics/environment.h"
#include "core/semantics/step_log.h"
#include "core/semantics/work_set.h"

namespace race::semantics {

class StepContext {
 public:
  StepContext(const Program& p, RunState& r, Workspace& w) : program(p), run(r), work(w) {}
  StepContext(const StepContext&) = delete;
  StepContext& operator=(const StepContext&) = delete;

  // Φ
  template <typename Node>
  bool is_active(Node x) const {
    return run.flags[program.flag(x)] != 0;
  }
  void set_active(StateId s);
  void set_active(BarrierId b);
  void set_active(PortId p);
  void set_inactive(StateId s);
  void set_inactive(BarrierId b);
  void set_inactive(PortId p);
  bool has_arrived(PortId p) const { return run.arrived[index(p)] != 0; }
  /// Whether all inbound ports of `b` have arrived when `p` arrives.
  /// OPTIMIZATION: they are counted.
  bool completes(BarrierId b, PortId p) const {
    return run.arrivals[index(b)] + (has_arrived(p) ? 0 : 1) == program[b].in.size();
  }
  void add_arrival(BarrierId b, PortId p);
  void clear_arrivals(BarrierId b);

  /// active_ports(Δ,s) of 3.28 and active_barriers(Δ,s) of 3.29, in declared order: taken off the lists of `s`. Valid
  /// until the next time.
  std::vector<PortId>& take_active_ports(StateId s);
  std::vector<BarrierId>& take_active_barriers(StateId s);

  /// R8, R22: what an earlier activation of `s` left is gone, unless `keep` says otherwise.
  void clear_earlier_activation(StateId s);
  /// R8: `s` was left through `p`; none: with its parent (R26).
  void set_left_through(StateId s, PortId p);

  // Σ: executed (3.16, R19), triggered (R9) and occurrences (R21)
  bool is_executed(ActionId a) const { return run.executed[a] == run.epoch; }
  void set_executed(ActionId a);
  bool is_delivered_anew(StateId s, ActionId a) const;
  void clear_served(ActionId a) { run.served[a] = 0; }
  /// R9: whether the port `p` of `s`, whose condition is fulfilled, has fired in this macro step. Then rechecks `s`.
  bool is_held_back(StateId s, PortId p);
  void set_triggered(PortId p);
  /// `s` is evaluated again in the next macro step, in which `executed` and `triggered` are empty.
  void recheck(StateId s) { recheck_in_next_macro_step(run, s); }
  bool ports_see_occurrence(StateId s) const { return live(s).activated_in != run.epoch; }

  /// Gives a call of `s` its number; it leaves the run with the micro step (R16).
  void send(StateId s, BufferedCall call);

  Live& live(StateId s) { return run.live[index(s)]; }
  const Live& live(StateId s) const { return run.live[index(s)]; }

  const Program& program;
  RunState& run;
  Workspace& work;
  /// R14: whether this micro step changed Δ, `executed` or `triggered`. Whatever changes does so with a flag, but
  /// actions.
  bool changed = false;

 private:
  // `owner`: the state that Reader::kOwner means.
  [[gnu::always_inline]] void set_flag(Flag flag, bool on, StateId owner, StateId parent) {
    work.log.flags.add(flag, run.flags[flag]);
    run.flags[flag] = on ? 1 : 0;
    changed = true;
    if (const std::uint8_t readers = program.flag_readers[flag]) mark_readers(readers, owner, parent);
  }
  [[gnu::noinline]] void mark_readers(std::uint8_t readers, StateId owner, StateId parent) {
    if (readers & kOwner) mark_dirty(run, owner);
    if (readers & kParent) mark_dirty(run, parent);
  }
  // Requires a change.
  void set_arrived(PortId p, bool on) {
    run.arrivals[program[p].to.number] += on ? 1U : ~0U;
    work.log.arrived.add(p, run.arrived[index(p)]);
    run.arrived[index(p)] = on ? 1 : 0;
  }
  void list_active_child(StateId s, StateId parent);
  void unlist_active_child(StateId s, StateId parent);
  bool keeps_values(StateId s) const;  // requires a state with `keep`
};

inline void StepContext::set_active(StateId s) {
  const StateInfo& info = program[s];
  set_flag(program.flag(s), true, s, info.parent);
  Live& state = live(s);
  // OPTIMIZATION: in this macro step its ports see no occurrence (R21): those that need one are not evaluated.
  if (!info.needs_occurrence || run.small_budget) mark_dirty(run, s);
  state.reevaluating = false;
  ++run.active_states;
  state.activated_in = run.epoch;
  state.activated_at = ++run.tick;
  state.calls_before = run.call_count;
  ++state.activations;
  if (info.parent != kNoState) list_active_child(s, info.parent);
}

// OPTIMIZATION: the active children are a list in order of declaration, which is the order of their numbers.
inline void StepContext::list_active_child(StateId s, StateId parent) {
  Live& state = live(s);
  Live& above = live(parent);
  StateId before = above.last_active;
  while (before != kNoState && index(before) > index(s)) before = live(before).previous;
  state.previous = before;
  state.next = before == kNoState ? above.first_active : live(before).next;
  (before == kNoState ? above.first_active : live(before).next) = s;
  (state.next == kNoState ? above.last_active : live(state.next).previous) = s;
  if (state.touched) return;
  state.touched = true;
  above.touched_children.push_back(s);
}

inline void StepContext::set_active(BarrierId b) {
  const StateId parent = program[b].parent;
  set_flag(program.flag(b), true, parent, parent);
  live(parent).active_barriers.push_back(b);
  run.work_set.add(parent);
}

// A port of `s` without destination, or of the root, stays active until its state is activated again or its parent is
// deactivated.
inline void StepContext::set_active(PortId p) {
  const PortInfo& info = program[p];
  const StateId parent = program[info.state].parent;
  set_flag(program.flag(p), true, info.state, parent);
  if (parent == kNoState) return;
  Live& above = live(parent);
  (info.to ? above.active_ports : above.unconnected_ports).push_back(p);
  if (info.to) run.work_set.add(parent);
}

inline void StepContext::set_inactive(StateId s) {
  const StateId parent = program[s].parent;
  set_flag(program.flag(s), false, s, parent);
  if (program[s].keeps) set_left_through(s, kNoPort);
  --run.active_states;
  if (parent != kNoState) unlist_active_child(s, parent);
}

inline void StepContext::unlist_active_child(StateId s, StateId parent) {
  const Live& state = live(s);
  Live& above = live(parent);
  (state.previous == kNoState ? above.first_active : live(state.previous).next) = state.next;
  (state.next == kNoState ? above.last_active : live(state.next).previous) = state.previous;
}

// The lists of the parent with active barriers and ports are emptied by those who walk them.
inline void StepContext::set_inactive(BarrierId b) {
  const StateId parent = program[b].parent;
  if (is_active(b)) set_flag(program.flag(b), false, parent, parent);
}

inline void StepContext::set_inactive(PortId p) {
  const StateId s = program[p].state;
  if (is_active(p)) set_flag(program.flag(p), false, s, program[s].parent);
}

inline void StepContext::add_arrival(BarrierId b, PortId p) {
  Live& above = live(program[b].parent);
  if (std::ranges::find(above.partial_barriers, b) == above.partial_barriers.end()) above.partial_barriers.push_back(b);
  if (!has_arrived(p)) set_arrived(p, true);
}

inline void StepContext::clear_arrivals(BarrierId b) {
  for (const PortId p : program[b].in)
    if (has_arrived(p)) set_arrived(p, false);
}

inline std::vector<PortId>& StepContext::take_active_ports(StateId s) {
  std::vector<PortId>& taken = work.ports;
  taken.clear();
  std::swap(taken, live(s).active_ports);
  const auto number = [](PortId p) { return index(p); };
  if (!std::ranges::is_sorted(taken, {}, number)) std::ranges::sort(taken, {}, number);
  return taken;
}

inline std::vector<BarrierId>& StepContext::take_active_barriers(StateId s) {
  std::vector<BarrierId>& taken = work.barriers;
  taken.clear();
  std::swap(taken, live(s).active_barriers);
  std::ranges::sort(taken, {}, [](BarrierId b) { return index(b); });
  for (const BarrierId b : taken) std::erase(live(s).partial_barriers, b);
  return taken;
}

// REFINEMENT R22: an arrival of an earlier activation is no arrival; and the ports of a state that is entered are
// inactive. REFINEMENT R8, R26: its values are initial, and a new life begins.
inline void StepContext::clear_earlier_activation(StateId s) {
  const StateInfo& info = program[s];
  for (const PortId p : info.ports) {
    if (has_arrived(p)) set_arrived(p, false);
    if (!is_active(p)) continue;
    set_flag(program.flag(p), false, s, info.parent);
    if (info.parent != kNoState) std::erase(live(info.parent).unconnected_ports, p);
  }
  const bool kept = info.keeps && keeps_values(s);
  if (!kept || !info.keeps_deep) live(s).life = live(s).activations;
  if (!kept && !info.stateless) reset_values(run, program, s, work.log.values);
  if (info.read_by_parent) mark_dirty(run, info.parent);
}

inline bool StepContext::keeps_values(StateId s) const {
  const StateInfo& info = program[s];
  const Live& state = live(s);
  if (info.parent == kNoState || state.left_during != live(info.parent).life) return false;
  if (state.left_through == kNoPort) return true;
  return info.keeps_any || std::ranges::find(info.keep_ports, state.left_through) != info.keep_ports.end();
}

// That a state was left with its parent counts if its `keep` is deep (R26); else it was left through no port.
inline void StepContext::set_left_through(StateId s, PortId p) {
  const StateInfo& info = program[s];
  if (!info.keeps || info.parent == kNoState) return;
  live(s).left_through = p;
  live(s).left_during = p != kNoPort || info.keeps_deep ? live(info.parent).life : 0;
}

inline void StepContext::set_executed(ActionId a) {
  run.executed[a] = run.epoch;
  run.served[a] = ++run.tick;
  changed = true;
}

// REFINEMENT R19: whether something that lets the action run again has come since it ran.
inline bool StepContext::is_delivered_anew(StateId s, ActionId a) const {
  const std::uint64_t served = run.served[a];
  if (served == 0 || live(s).activated_at > served) return true;
  const ActionInfo& action = program.actions[a];
  return std::ranges::any_of(action.events, [&](EventId e) { return run.event_tick[e] > served; }) ||
         std::ranges::any_of(action.responses, [&](OperationId o) { return run.response_tick[o] > served; });
}

inline bool StepContext::is_held_back(StateId s, PortId p) {
  if (!program[p].svc || run.triggered[index(p)] != run.epoch) return false;
  recheck(s);
  return true;
}

// REFINEMENT R9
inline void StepContext::set_triggered(PortId p) {
  if (!program[p].svc) return;
  work.log.triggered.add(p, run.triggered[index(p)]);
  run.triggered[index(p)] = run.epoch;
}

}  // namespace race::semantics
