// The activation layer (thesis 3.4.3): entering and leaving states and barriers. Upper layers say when, this one what
// it means.
#pragma once

#include "core/semantics/evaluation.h"

namespace race::semantics {

template <Recorder R>
void deactivate(Step<R>& step, NodeRef node);
template <Recorder R>
void activate(Step<R>& step, NodeRef node, PortId by);

// SDeact1 (3.19): leaving an inactive state deactivates its ports.
//
//   Δ ⊢ s.active ⇝ false    ∀ p_i ∈ s.ports, i = 1..n: Δ^{i-1} ⊢ p_i ⇝ p_i'[active = false],Δ^i
//   ───────────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s →↓ s,Δ^n
template <Recorder R>
void SDeact1(Step<R>& step, StateId s) {
  auto rule = step.apply(Rule::SDeact1, s);
  Active(step, s);
  for (const PortId p : ports(step, s))
    if (step.is_active(p)) Deact(step, p);
}

// SDeact2 (3.20): leaving an active state.
//
//   Δ ⊢ s.active ⇝ true    ∀ c ∈ s.children: Σ,Δ_c ⊢ c →↓ c',Δ'_c
//   Σ,Δ' ⊢ s.exit ⇝ s.exit,Δ''    Σ,Δ'' ⊢ s ⇝ s'[active = false],Δ'''
//   ──────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s →↓ s',Δ'''
template <Recorder R>
void SDeact2(Step<R>& step, StateId s) {
  auto rule = step.apply(Rule::SDeact2, s);
  Active(step, s);
  leave_children(step, s, [&](NodeRef c) { deactivate(step, c); });
  entry_or_exit(step, s, step.program[s].exit, FunctionOf::exit);
  Deact(step, s);
}

// BDeact (3.21): a barrier becomes inactive and forgets its arrivals.
//
//   Δ ⊢ b ⇝ b'[active = false],Δ'    Δ' ⊢ b' ⇝ b''[activated = ∅],Δ''
//   ──────────────────────────────────────────────────────────────────
//   Δ ⊢ b →↓ b'',Δ''
template <Recorder R>
void BDeact(Step<R>& step, BarrierId b, Refinement refinement = 0) {
  auto rule = step.apply(Rule::BDeact, b);
  rule.refinement(refinement);
  if (step.is_active(b)) Deact(step, b);
  step.clear_arrivals(b);
}

/// →↓ of a state or barrier: the rule that applies.
template <Recorder R>
void deactivate(Step<R>& step, NodeRef node) {
  if (node.barrier) return BDeact(step, node.as_barrier());
  step.is_active(node.state()) ? SDeact2(step, node.state()) : SDeact1(step, node.state());
}

// SAct1 (3.22): entering an inactive state.
//
//   Δ ⊢ s.active ⇝ false    Δ ⊢ s ⇝ s'[active = true],Δ'    Σ,Δ' ⊢ s.entry ⇝ s.entry,Δ''
//   ∀ f ∈ s.first: Σ,Δ_f,∅ ⊢ f →↑ f',Δ'_f
//   ──────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ,p ⊢ s →↑ s',Δ'''
//
// REFINEMENT R8, R22: nothing of an earlier activation is left. The parameters of f are resolved before it is
// activated, as 3.2.3 says.
template <Recorder R>
void SAct1(Step<R>& step, StateId s, PortId p) {
  auto rule = step.apply(Rule::SAct1, s, p);
  Active(step, s);
  Act(step, s);
  step.clear_earlier_activation(s);
  entry_or_exit(step, s, step.program[s].entry, FunctionOf::entry);
  if (const NodeRef f = step.program[s].first) {
    if (!f.barrier) resolve_parameters(step, f.state());
    activate(step, f, kNoPort);
  }
}

// SAct2 (3.23): entering a state that is active already.
//
//   Δ ⊢ s.active ⇝ true
//   ────────────────────
//   Σ,Δ,p ⊢ s →↑ s
//
// REFINEMENT R10: its parameters are not resolved again.
template <Recorder R>
void SAct2(Step<R>& step, StateId s, PortId p) {
  auto rule = step.apply(Rule::SAct2, s, p);
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
  auto rule = step.apply(Rule::BAct1, b);
  Active(step, b);
  Act(step, b);
}

// BAct2 (3.25): the last missing port arrives.
//
//   Δ ⊢ b.active ⇝ false    Δ ⊢ b ⇝ b'[activated ∪= p],Δ'
//   ∀ p_i ∈ b.in: Δ' ⊢ b.activated(p_i) ⇝ true    Δ' ⊢ b ⇝ b'[active = true],Δ''
//   ─────────────────────────────────────────────────────────────────────────────
//   Σ,Δ,p ⊢ b →↑ b',Δ''
//
// REFINEMENT R11: an active barrier stays as it is.
template <Recorder R>
void BAct2(Step<R>& step, BarrierId b, PortId p) {
  auto rule = step.apply(Rule::BAct2, b, p);
  if (Active(step, b)) return rule.refinement(11);
  BIn(step, b, p);
  for (const PortId p_i : shown_inbound_ports(step, b)) Activated(step, b, p_i);
  Act(step, b);
}

// BAct3 (3.26): a port arrives, others are still missing.
//
//   Δ ⊢ b.active ⇝ false    Δ ⊢ b ⇝ b'[activated ∪= p],Δ'
//   ∃ p_i ∈ b.in: Δ' ⊢ b.activated(p_i) ⇝ false
//   ──────────────────────────────────────────────────────
//   Σ,Δ,p ⊢ b →↑ b',Δ'
template <Recorder R>
void BAct3(Step<R>& step, BarrierId b, PortId p) {
  auto rule = step.apply(Rule::BAct3, b, p);
  Active(step, b);
  BIn(step, b, p);
  for (const PortId p_i : shown_inbound_ports(step, b))
    if (!Activated(step, b, p_i)) break;
}

/// →↑ of a state or barrier: the rule that applies. `by`: the port that leads there, or none.
template <Recorder R>
void activate(Step<R>& step, NodeRef node, PortId by) {
  if (!node.barrier) {
    step.is_active(node.state()) ? SAct2(step, node.state(), by) : SAct1(step, node.state(), by);
    return;
  }
  const BarrierId b = node.as_barrier();
  if (by == kNoPort) return BAct1(step, b);
  step.is_active(b) || step.completes(b, by) ? BAct2(step, b, by) : BAct3(step, b, by);
}

}  // namespace race::semantics
