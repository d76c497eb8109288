// Traversal: which elements the premises "for all" of the rules come to, and in which order. A derivation shows them
// all. Without one, those that have no work are passed over: their rules would have no effect; and the order is the
// declared one, at compile time.
#pragma once

#include "core/semantics/step.h"

namespace race::semantics {

/// The ports of `s`, in order.
template <Recorder R>
auto ports(const Step<R>& step, StateId s) {
  if constexpr (R::kVisitsAll)
    return step.order.ports(step.program, s);
  else
    return step.program[s].ports;
}

/// REFINEMENT R24: the port of `s` that somebody has forced, in the activation that there was then; or none.
/// OPTIMIZATION: without a derivation, none: a driver takes a recorder that visits all then.
template <Recorder R>
PortId forced_port(const Step<R>& step, StateId s) {
  if (!R::kVisitsAll) return kNoPort;
  const PortId p = step.run.forced;
  return p != kNoPort && step.program[p].state == s && step.ports_see_occurrence(s) ? p : kNoPort;
}

/// The actions of `s`, in order.
/// OPTIMIZATION: without a derivation, none if nothing that its conditions and actions read has changed.
template <Recorder R>
auto actions_to_try(const Step<R>& step, StateId s) {
  if constexpr (R::kVisitsAll)
    return step.order.actions(step.program, s);
  else
    return step.live(s).reevaluating ? step.program[s].actions : Range<ActionId>{};
}

/// active_ports(Δ,s) of 3.28: children in order and ports in order. Taken off the lists of `s`.
template <Recorder R>
const std::vector<PortId>& take_active_ports(Step<R>& step, StateId s) {
  std::vector<PortId>& taken = step.take_active_ports(s);
  if constexpr (R::kVisitsAll) step.order.sort(taken);
  return taken;
}

/// active_barriers(Δ,s) of 3.29, in order. Taken off the lists of `s`.
template <Recorder R>
const std::vector<BarrierId>& take_active_barriers(Step<R>& step, StateId s) {
  std::vector<BarrierId>& taken = step.take_active_barriers(s);
  if constexpr (R::kVisitsAll) step.order.sort(taken);
  return taken;
}

/// Applies `visit` to active_states(Δ,s) of 3.30, in order. One that is left while it is visited does not disturb the
/// others.
/// OPTIMIZATION: without a derivation, to none: visit_active_states comes to those that have work. In declared order,
/// along the list of those that are active.
template <Recorder R, typename Visit>
void for_each_active_state(Step<R>& step, StateId s, Visit visit) {
  if constexpr (R::kVisitsAll) {
    if (!step.order.is_declared()) {
      for (const NodeRef c : step.order.children(step.program, s))
        if (!c.barrier && step.is_active(c.state())) visit(c.state());
      return;
    }
    for (StateId c = step.live(s).first_active, next; c != kNoState; c = next) {
      next = step.live(c).next;
      visit(c);
    }
  }
}

/// Applies `visit` to the root, and so, by SProp, to every active state.
/// OPTIMIZATION: without a derivation, to the active states of the work set, in tree order, which is the order in which
/// SProp would come to them; to none below a state for which `visit` says false: it did not take SProp.
template <Recorder R, typename Visit>
void visit_active_states(Step<R>& step, Visit visit) {
  if (R::kVisitsAll) {
    visit(Program::root);
    return;
  }
  StateSet& work_set = step.run.work_set;
  for (StateId s = work_set.next(0); s != kNoState;) {
    std::uint32_t next = index(s) + 1;
    if (!step.is_active(s))
      work_set.remove(s);
    else if (!visit(s))
      next = step.program[s].end;
    s = work_set.next(next);
  }
}

/// The visit of `s` begins: it is in the work set no longer, and reevaluates if something that it reads has changed.
/// In another order than the declared one it reevaluates in any case, and stays dirty for a step in a third order:
/// where R9 holds back a port, whether another one fires is a matter of the order.
template <Recorder R>
void begin_visit(Step<R>& step, StateId s) {
  Live& state = step.live(s);
  if constexpr (R::kVisitsAll) {
    if (!step.order.is_declared()) {
      mark_dirty(step.run, s);
      state.reevaluating = true;
      return;
    }
  }
  state.reevaluating = state.dirty || R::kReevaluatesAll;
  state.dirty = false;
  step.run.work_set.remove(s);
}

/// Applies `leave` to the children of `s`, which is left, in order; then nothing of them is active.
/// OPTIMIZATION: without a derivation, only to those that are active, or have active ports or arrivals.
template <Recorder R, typename Leave>
void leave_children(Step<R>& step, StateId s, Leave leave) {
  if (step.program[s].children.empty()) return;
  Live& state = step.live(s);
  if (R::kVisitsAll) {
    for (const NodeRef child : step.order.children(step.program, s)) leave(child);
  } else {
    const auto leave_state = [&](StateId child) { leave(NodeRef{false, index(child)}); };
    while (state.first_active != kNoState) leave_state(state.first_active);
    for (const auto* ports : {&state.active_ports, &state.unconnected_ports})
      for (const PortId p : *ports) leave_state(step.program[p].state);
    for (const auto* barriers : {&state.active_barriers, &state.partial_barriers})
      for (const BarrierId b : *barriers) leave(NodeRef{true, index(b)});
  }
  state.active_ports.clear();
  state.unconnected_ports.clear();
  state.active_barriers.clear();
  state.partial_barriers.clear();
}

/// The inbound ports of `b`, in order, for a rule that has found out all that it needs.
/// OPTIMIZATION: without a derivation, none.
template <Recorder R>
std::span<const PortId> shown_inbound_ports(const Step<R>& step, BarrierId b) {
  if (!R::kVisitsAll) return {};
  return step.order.inbound(step.program, b);
}

}  // namespace race::semantics
