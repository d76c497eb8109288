// The activation layer (thesis 3.4.3): entering and leaving states and barriers. Upper layers say when, this one what
// it means.
#pragma once

#include "core/semantics/atomic.h"

namespace race::semantics {

// SDeact1 (3.19): leaving an inactive state deactivates its ports.
//
//   Δ ⊢ s.active ⇝ false    ∀ p ∈ s.ports: Δ ⊢ p ⇝ p'[active = false]
//   ──────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s →↓ s,Δ'
template <Recorder R>
void SDeact1(Step<R>& step, StateId s) {
  OpenNode<R> rule = step.apply(Rule::SDeact1, s);
  Active(step, s);
  for (const PortId p : step.program[s].ports)
    if (step.is_active(p)) Deact(step, p);
}

// BDeact (3.21): a barrier becomes inactive and forgets its arrivals.
//
//   Δ ⊢ b ⇝ b'[active = false],Δ'    Δ' ⊢ b' ⇝ b''[activated = ∅],Δ''
//   ──────────────────────────────────────────────────────────────────
//   Δ ⊢ b →↓ b'',Δ''
template <Recorder R>
void BDeact(Step<R>& step, BarrierId b, Refinement refinement = 0) {
  OpenNode<R> rule = step.apply(Rule::BDeact, b);
  rule.refinement(refinement);
  if (step.is_active(b)) Deact(step, b);
  for (const PortId p : step.program[b].in)
    if (step.run.arrived[index(p)]) step.set_arrived(p, false);
}

template <Recorder R>
void SDeact2(Step<R>& step, StateId s);

// OPTIMIZATION: without a derivation only children that are active, or have active ports or arrivals, are visited; the
// others would contribute rules without effect.
template <Recorder R>
void leave_children(Step<R>& step, StateId s) {
  if constexpr (R::kRecords) {
    for (const NodeRef child : step.program[s].children) {
      if (child.barrier)
        BDeact(step, child.as_barrier());
      else if (step.is_active(child.state()))
        SDeact2(step, child.state());
      else
        SDeact1(step, child.state());
    }
  } else {
    if (step.program[s].children.empty()) return;
    const Live& live = step.live(s);
    while (live.first_active != kNoState) SDeact2(step, live.first_active);
    for (const auto* ports : {&live.pending, &live.lingering})
      for (const PortId p : *ports) Deact(step, p);
    for (const auto* barriers : {&live.open, &live.waiting})
      for (const BarrierId b : *barriers) BDeact(step, b);
  }
  Live& live = step.live(s);
  live.pending.clear();
  live.lingering.clear();
  live.open.clear();
  live.waiting.clear();
}

// SDeact2 (3.20): leaving an active state.
//
//   Δ ⊢ s.active ⇝ true    ∀ c ∈ s.children: Σ,Δ_c ⊢ c →↓ c',Δ'_c
//   Σ,Δ' ⊢ s.exit ⇝ s.exit,Δ''    Σ,Δ'' ⊢ s ⇝ s'[active = false],Δ'''
//   ──────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s →↓ s',Δ'''
template <Recorder R>
void SDeact2(Step<R>& step, StateId s) {
  OpenNode<R> rule = step.apply(Rule::SDeact2, s);
  Active(step, s);
  leave_children(step, s);
  Func(step, s, step.program[s].exit, FunctionOf::exit);
  Deact(step, s);
}

template <Recorder R>
void activate(Step<R>& step, NodeRef node, PortId by);

// REFINEMENT R8: behaviour depends on parameters only: what an earlier activation left is gone, unless `keep` says
// otherwise.
template <Recorder R>
void forget_earlier_activation(Step<R>& step, StateId s) {
  const StateInfo& info = step.program[s];
  if (info.bare) return;
  const Live& live = step.live(s);
  if (info.keeps && info.parent != kNoState && live.left_through != kNoPort &&
      live.left_during == step.live(info.parent).activations &&
      (info.keeps_any || std::ranges::find(info.keep_ports, live.left_through) != info.keep_ports.end()))
    return;
  reset_values(step.run, step.program, s, step.work.log.values);
}

// REFINEMENT R22: an arrival of an earlier activation is no arrival; and the ports of a state that is entered are
// inactive.
template <Recorder R>
void withdraw_ports(Step<R>& step, StateId s) {
  const StateId parent = step.program[s].parent;
  for (const PortId p : step.program[s].ports) {
    if (step.run.arrived[index(p)]) step.set_arrived(p, false);
    if (!step.is_active(p)) continue;
    step.set_flag(step.program.flag(p), false, s, parent);
    if (parent != kNoState) std::erase(step.live(parent).lingering, p);
  }
}

// SAct1 (3.22): entering an inactive state.
//
//   Δ ⊢ s.active ⇝ false    Δ ⊢ s ⇝ s'[active = true],Δ'    Σ,Δ' ⊢ s.entry ⇝ s.entry,Δ''
//   ∀ f ∈ s.first: Σ,Δ_f,∅ ⊢ f →↑ f',Δ'_f
//   ──────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ,p ⊢ s →↑ s',Δ'''
template <Recorder R>
void SAct1(Step<R>& step, StateId s, PortId by) {
  OpenNode<R> rule = step.apply(Rule::SAct1, s, by);
  Active(step, s);
  Act(step, s);
  withdraw_ports(step, s);
  forget_earlier_activation(step, s);
  if (step.program[s].watched) wake(step.run, step.program[s].parent);
  Func(step, s, step.program[s].entry, FunctionOf::entry);
  if (const NodeRef first = step.program[s].first) {
    if (!first.barrier) resolve_parameters(step, first.state());
    activate(step, first, kNoPort);
  }
}

// SAct2 (3.23):   Δ ⊢ s.active ⇝ true   ⟹   Σ,Δ,p ⊢ s →↑ s        REFINEMENT R10: its parameters are not resolved
// again.
template <Recorder R>
void SAct2(Step<R>& step, StateId s, PortId by) {
  OpenNode<R> rule = step.apply(Rule::SAct2, s, by);
  rule.refinement(10);
  Active(step, s);
}

// BAct1 (3.24): a barrier that is the first child.
//
//   Δ ⊢ b.active ⇝ false    p = ∅    Δ ⊢ b ⇝ b'[active = true],Δ'
//   ──────────────────────────────────────────────────────────────
//   Σ,Δ,p ⊢ b →↑ b',Δ'
template <Recorder R>
void BAct1(Step<R>& step, BarrierId b) {
  OpenNode<R> rule = step.apply(Rule::BAct1, b);
  Active(step, b);
  Act(step, b);
}

// BAct2 (3.25), BAct3 (3.26): a port arrives; with it all have arrived, or not yet.
//
//   Δ ⊢ b.active ⇝ false    Δ ⊢ b ⇝ b'[activated ∪= p],Δ'
//   ∀ p_i ∈ b.in: Δ' ⊢ b.activated(p_i) ⇝ true    Δ' ⊢ b ⇝ b'[active = true],Δ''
//   ─────────────────────────────────────────────────────────────────────────────
//   Σ,Δ,p ⊢ b →↑ b',Δ''
template <Recorder R>
void BAct23(Step<R>& step, BarrierId b, PortId p) {
  OpenNode<R> rule = step.apply(Rule::BAct2, b, p);
  if (Active(step, b)) {  // REFINEMENT R11: an active barrier stays as it is
    rule.refinement(11);
    return;
  }
  const std::size_t mark = step.mark();
  BIn(step, b, p);
  if constexpr (!R::kRecords) {  // OPTIMIZATION: arrivals are counted
    if (step.run.arrivals[index(b)] == step.program[b].in.size()) Act(step, b);
    return;
  }
  for (const PortId in : step.program[b].in) {
    if (Activated(step, b, in)) continue;
    if constexpr (R::kTree) rule.node().rule = Rule::BAct3;
    if constexpr (R::kRecords && !R::kTree) step.recorder.names[mark - 2] = Rule::BAct3;
    return;
  }
  Act(step, b);
}

/// →↑ of a state or barrier: the first rule that applies. `by`: the port that leads there, or none.
template <Recorder R>
void activate(Step<R>& step, NodeRef node, PortId by) {
  if (node.barrier) return by == kNoPort ? BAct1(step, node.as_barrier()) : BAct23(step, node.as_barrier(), by);
  if (step.is_active(node.state())) return SAct2(step, node.state(), by);
  SAct1(step, node.state(), by);
}

}  // namespace race::semantics
