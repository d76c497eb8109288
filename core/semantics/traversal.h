// Traversal: which elements the premises "for all" of the rules come to. A derivation shows them all. Without one,
// those that have no work are passed over: their rules would have no effect.
#pragma once

#include "core/semantics/step.h"

namespace race::semantics {

/// The actions of `s`.
/// OPTIMIZATION: without a derivation, none if nothing that its conditions and actions read has changed.
template <Recorder R>
Range<ActionId> actions_to_try(const Step<R>& step, StateId s) {
  if (!R::kVisitsAll && !step.live(s).reevaluating) return {};
  return step.program[s].actions;
}

/// Active states, from one along its siblings. One that is left while it is visited does not disturb the others.
struct SiblingRange {
  struct Iterator {
    const RunState& run;
    StateId at, next;
    StateId operator*() const { return at; }
    Iterator& operator++() {
      at = next;
      if (at != kNoState) next = run.live[index(at)].next;
      return *this;
    }
    bool operator==(StateId end) const { return at == end; }
  };
  const RunState& run;
  StateId first;
  Iterator begin() const { return {run, first, first == kNoState ? kNoState : run.live[index(first)].next}; }
  StateId end() const { return kNoState; }
};

/// active_states(Δ,s) of 3.30.
/// OPTIMIZATION: without a derivation, none: visit_active_states comes to those that have work.
template <Recorder R>
SiblingRange active_states(const Step<R>& step, StateId s) {
  return {step.run, R::kVisitsAll ? step.live(s).first_active : kNoState};
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
template <Recorder R>
void begin_visit(Step<R>& step, StateId s) {
  Live& state = step.live(s);
  state.reevaluating = state.dirty || R::kReevaluatesAll;
  state.dirty = false;
  step.run.work_set.remove(s);
}

/// Applies `leave` to the children of `s`, which is left; then nothing of them is active.
/// OPTIMIZATION: without a derivation, only to those that are active, or have active ports or arrivals.
template <Recorder R, typename Leave>
void leave_children(Step<R>& step, StateId s, Leave leave) {
  if (step.program[s].children.empty()) return;
  Live& state = step.live(s);
  if (R::kVisitsAll) {
    for (const NodeRef child : step.program[s].children) leave(child);
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

/// Elements of which the rule that is applied has found out all that it needs.
/// OPTIMIZATION: without a derivation, none.
template <Recorder R, typename Elements>
std::span<const typename Elements::value_type> shown(const Step<R>&, const Elements& elements) {
  if (!R::kVisitsAll) return {};
  return elements;
}

}  // namespace race::semantics
