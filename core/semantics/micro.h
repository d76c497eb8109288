// The micro layer (thesis 3.4.4): what one state does in one micro step. The first rule that applies, in this order:
// PTrigger, PTrans1, PTrans2, SProp.
#pragma once

#include "core/semantics/activation.h"

namespace race::semantics {

template <Recorder R>
bool visit(Step<R>& step, StateId s);

/// The first port of `s` in order whose condition is fulfilled.
/// REFINEMENT R9: a port whose condition mentions svc fires once in a macro step; where it would fire again, no port
/// fires. REFINEMENT R21: it does not see the occurrence of the macro step in which its state was activated.
template <Recorder R>
inline PortId first_fulfilled_port(Step<R>& step, StateId s) {
  const bool sees_occurrence = step.live(s).activated_in != step.run.epoch;
  for (const PortId p : step.program[s].ports) {
    const PortInfo& port = step.program[p];
    if (step.untraced(port.when, s, sees_occurrence) != language::Truth::yes) continue;
    if (!port.svc || step.run.triggered[index(p)] != step.run.epoch) return p;
    if (!step.live(s).recheck) {
      step.live(s).recheck = true;
      step.run.recheck.push_back(s);
    }
    return kNoPort;
  }
  return kNoPort;
}

// PTrigger (3.27): a port whose condition is fulfilled takes its state out of play.
//
//   Δ ⊢ s.active ⇝ true     p ∈ s.ports    Σ,Δ ⊢ p.cond ⇝ true
//   Σ,Δ ⊢ s →↓ s',Δ'        Δ' ⊢ p ⇝ p'[active = true],Δ''
//   ────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s',Δ''
template <Recorder R>
bool PTrigger(Step<R>& step, StateId s) {
  if (!step.live(s).looking) return false;
  const PortId p = first_fulfilled_port(step, s);
  if (p == kNoPort) return false;
  OpenNode<R> rule = step.apply(Rule::PTrigger, s, p);
  Active(step, s);
  if constexpr (R::kTree) step.truth(step.program[p].when, s, step.live(s).activated_in != step.run.epoch);
  step.record_condition(s, p, kNone, language::Truth::yes);
  if (step.program[p].svc) {
    step.work.log.triggered.add(p, step.run.triggered[index(p)]);
    step.run.triggered[index(p)] = step.run.epoch;
  }
  SDeact2(step, s);
  Act(step, p);
  if (step.program[s].keeps && step.program[s].parent != kNoState) {
    step.live(s).left_through = p;
    step.live(s).left_during = step.live(step.program[s].parent).activations;
  }
  step.changed = true;
  return true;
}

// PTrans1 (3.28): active ports of children lead to their destinations.
//
//   Δ ⊢ s.active ⇝ true    active_ports(Δ,s) ≠ ∅    ∀ a ∈ s.actions: Σ,Δ^{i-1} ⊢ a ⇝ a,Δ^i
//   ∀ (p,d) ∈ active_ports(Δ,s): Σ,Δ_d,p ⊢ d →↑ d',Δ'_d    Δ_p ⊢ p ⇝ p'[active = false],Δ'_p
//   ─────────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s,Δ'
template <Recorder R>
bool PTrans1(Step<R>& step, StateId s) {
  if (step.live(s).pending.empty()) return false;
  OpenNode<R> rule = step.apply(Rule::PTrans1, s);
  Active(step, s);
  actions_of(step, s);
  // The list of (p, d) is taken once: children in order and ports in order, which is the order of the ports' numbers.
  std::vector<PortId>& taken = step.work.ports;
  taken.clear();
  std::swap(taken, step.live(s).pending);
  const auto number = [](PortId p) { return index(p); };
  if (!std::ranges::is_sorted(taken, {}, number)) std::ranges::sort(taken, {}, number);
  if constexpr (!R::kTree) {
    resolve_destinations(step, taken);
    for (const PortId p : taken) {
      activate(step, step.program[p].to, p);
      Deact(step, p);
    }
  } else {
    // REFINEMENT R23: the parameters are resolved first, so that targets do not depend on each other's order; a
    // derivation shows each Resolve before the activation of its target.
    const std::size_t mark = step.mark();
    resolve_destinations(step, taken);
    std::vector<DerivationNode> resolved(step.recorder.derivation.nodes.begin() + static_cast<std::ptrdiff_t>(mark),
                                         step.recorder.derivation.nodes.end());
    step.forget(mark);
    for (const PortId p : taken) {
      show_resolved(step, resolved, step.program[p].to);
      activate(step, step.program[p].to, p);
      Deact(step, p);
    }
  }
  step.changed = true;
  return true;
}

/// The parameters of `s`, if it is inactive and they have not been resolved in this transition.
template <Recorder R>
void resolve_once(Step<R>& step, StateId s) {
  if (step.is_active(s) || step.live(s).resolved_in == step.run.transitions) return;
  step.live(s).resolved_in = step.run.transitions;
  resolve_parameters(step, s);
}

/// The parameters of every destination that is an inactive state, once each.
template <Recorder R>
void resolve_destinations(Step<R>& step, const std::vector<PortId>& ports) {
  ++step.run.transitions;
  for (const PortId p : ports)
    if (const NodeRef to = step.program[p].to; !to.barrier) resolve_once(step, to.state());
}

/// Moves the recorded Resolve nodes of `to` into the derivation.
template <Recorder R>
void show_resolved(Step<R>& step, std::vector<DerivationNode>& resolved, NodeRef to) {
  if (to.barrier) return;
  const Flag at = step.program.flag(to.state());
  for (const DerivationNode& node : resolved)
    if (node.at == at) step.recorder.derivation.nodes.push_back(node);
  std::erase_if(resolved, [&](const DerivationNode& node) { return node.at == at; });
}

// PTrans2 (3.29): an open barrier leads to all of its destinations.
//
//   Δ ⊢ s.active ⇝ true    active_barriers(Δ,s) ≠ ∅    ∀ a ∈ s.actions: Σ,Δ^{i-1} ⊢ a ⇝ a,Δ^i
//   ∀ b ∈ active_barriers(Δ,s), d ∈ b.out: Σ,Δ_d,∅ ⊢ d →↑ d',Δ'_d    Δ_b ⊢ b →↓ b',Δ'_b
//   ────────────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s,Δ'
template <Recorder R>
bool PTrans2(Step<R>& step, StateId s) {
  if (step.live(s).open.empty()) return false;
  OpenNode<R> rule = step.apply(Rule::PTrans2, s);
  Active(step, s);
  actions_of(step, s);
  std::vector<BarrierId>& taken = step.work.barriers;
  taken.clear();
  std::swap(taken, step.live(s).open);
  std::ranges::sort(taken, {}, [](BarrierId b) { return index(b); });
  for (const BarrierId b : taken) {
    std::erase(step.live(s).waiting, b);
    open_barrier(step, b);
  }
  step.changed = true;
  return true;
}

/// One barrier of PTrans2: its targets, then REFINEMENT R12: it forgets its arrivals, so that a second round waits for
/// all again.
template <Recorder R>
void open_barrier(Step<R>& step, BarrierId b) {
  const std::vector<StateId>& to = step.program[b].to;
  const std::size_t mark = step.mark();
  ++step.run.transitions;
  for (const StateId d : to) resolve_once(step, d);
  if constexpr (R::kTree) {
    std::vector<DerivationNode> resolved(step.recorder.derivation.nodes.begin() + static_cast<std::ptrdiff_t>(mark),
                                         step.recorder.derivation.nodes.end());
    step.forget(mark);
    for (const StateId d : to) {
      show_resolved(step, resolved, {false, index(d)});
      activate(step, {false, index(d)}, kNoPort);
    }
  } else {
    for (const StateId d : to) activate(step, {false, index(d)}, kNoPort);
  }
  BDeact(step, b, 12);
}

// SProp (3.30): actions, then every active child takes its micro step.
//
//   Δ ⊢ s.active ⇝ true    ∀ a ∈ s.actions: Σ,Δ^{i-1} ⊢ a ⇝ a,Δ^i
//   ∀ c ∈ active_states(Δ,s): Σ,Δ_c ⊢ c → c',Δ'_c
//   ──────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s,Δ'
template <Recorder R>
bool SProp(Step<R>& step, StateId s) {
  OpenNode<R> rule = step.apply(Rule::SProp, s);
  Active(step, s);
  actions_of(step, s);
  if constexpr (R::kRecords) {
    for (StateId c = step.live(s).first_active; c != kNoState;) {
      const StateId next = step.live(c).next;  // c may leave the list, its siblings stay
      visit(step, c);
      c = next;
    }
  }
  return true;
}

/// One micro transition of an active state. Returns whether its children take theirs too: whether it was SProp.
template <Recorder R>
bool visit(Step<R>& step, StateId s) {
  Live& live = step.live(s);
  live.looking = live.dirty || R::kLooksAgain;
  live.dirty = false;
  step.run.hot.remove(s);
  // OPTIMIZATION: the rules look at these themselves; not calling them costs less.
  if (live.looking && PTrigger(step, s)) return false;
  if (!live.pending.empty() && PTrans1(step, s)) return false;
  if (!live.open.empty() && PTrans2(step, s)) return false;
  return SProp(step, s);
}

/// The micro transition of the root, and so of the model.
/// OPTIMIZATION: without a derivation only the states that have something to look at are visited, in tree order, which
/// is the order in which SProp would come to them; below a state that did not take SProp none is.
template <Recorder R>
void visit_root(Step<R>& step) {
  if constexpr (R::kRecords) {
    visit(step, Program::root);
  } else {
    StateSet& hot = step.run.hot;
    for (StateId s = hot.next(0); s != kNoState;) {
      std::uint32_t next = index(s) + 1;
      if (!step.is_active(s))
        hot.remove(s);
      else if (!visit(step, s))
        next = step.program[s].end;
      s = hot.next(next);
    }
  }
}

}  // namespace race::semantics
