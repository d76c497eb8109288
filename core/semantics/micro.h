// The micro layer (thesis 3.4.4): what one state does in one micro step, and what the model does.
#pragma once

#include <array>
#include <utility>

#include "core/semantics/activation.h"
#include "core/semantics/destinations.h"

namespace race::semantics {

/// The first port of `s` in order whose condition is fulfilled, or none.
/// REFINEMENT R9: a port whose condition mentions svc fires once in a macro step; where it would fire again, no port
/// fires. REFINEMENT R21: it does not see the occurrence of the macro step in which its state was activated.
template <Recorder R>
[[gnu::always_inline]] inline PortId first_fulfilled_port(Step<R>& step, StateId s) {
  const bool sees_occurrence = step.ports_see_occurrence(s);
  for (const PortId p : ports(step, s)) {
    const PortInfo& port = step.program[p];
    step.recorder.turn(p);
    if (step.untraced_truth(port.when, s, sees_occurrence) != language::Truth::yes) continue;
    return step.is_held_back(s, p) ? kNoPort : p;
  }
  return kNoPort;
}

/// REFINEMENT R24: a condition that counts as fulfilled, whatever it is.
template <Recorder R>
void forced_condition(Step<R>& step, StateId s, PortId p) {
  auto rule = step.apply(Rule::Cond, s, p);
  rule.value(language::Truth::yes);
  rule.refinement(24);
}

// PTrigger (3.27): a port whose condition is fulfilled takes its state out of play.
//
//   Δ ⊢ s.active ⇝ true     p ∈ s.ports    Σ,Δ ⊢ p.cond ⇝ true
//   Σ,Δ ⊢ s →↓ s',Δ'        Δ' ⊢ p ⇝ p'[active = true],Δ''
//   ────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s',Δ''
template <Recorder R>
bool PTrigger(Step<R>& step, StateId s) {
  const PortId forced = forced_port(step, s);
  const PortId p = forced == kNoPort ? first_fulfilled_port(step, s) : forced;
  if (p == kNoPort) return false;
  auto rule = step.apply(Rule::PTrigger, s, p);
  Active(step, s);
  if (forced == kNoPort) {
    step.trace(step.program[p].when, s, step.ports_see_occurrence(s));
    Cond(step, s, p, language::Truth::yes);
  } else {
    forced_condition(step, s, p);
  }
  step.set_triggered(p);
  SDeact2(step, s);
  Act(step, p);
  step.set_left_through(s, p);
  return true;
}

// PTrans1 (3.28): active ports of children lead to their destinations.
//
//   Δ ⊢ s.active ⇝ true    ∀ a_i ∈ s.actions, i = 1..n: Σ,Δ^{i-1} ⊢ a_i ⇝ a_i,Δ^i → Δ'
//   ∀ (p,d) ∈ active_ports(Δ',s) ≠ ∅:    ∀ pa ∈ d.parameters: Δ' ⊢ pa.expr ⇝ c ∈ C,Δ'_d[Π']
//     Σ,Δ'_d,p ⊢ d →↑ d',Δ''_d    Δ_p ⊢ p ⇝ p'[active = false],Δ'_p
//   ───────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s,Δ''
//
// REFINEMENT R23: all parameters are resolved first, so that destinations do not depend on each other's order.
template <Recorder R>
bool PTrans1(Step<R>& step, StateId s) {
  auto rule = step.apply(Rule::PTrans1, s);
  Active(step, s);
  evaluate_actions(step, s);
  const std::vector<PortId>& active_ports = take_active_ports(step, s);
  ResolvedDestinations<R> destinations(step, active_ports);
  for (const PortId p : active_ports) {
    destinations.add_premises(p);
    activate(step, destination(step.program, p), p);
    Deact(step, p);
  }
  return true;
}

// PTrans2 (3.29): an open barrier leads to all of its destinations.
//
//   Δ ⊢ s.active ⇝ true    ∀ a_i ∈ s.actions, i = 1..n: Σ,Δ^{i-1} ⊢ a_i ⇝ a_i,Δ^i → Δ'
//   ∀ b ∈ active_barriers(Δ',s) ≠ ∅:
//     ∀ d ∈ b.out:    ∀ pa ∈ d.parameters: Δ' ⊢ pa.expr ⇝ c ∈ C,Δ'_d[Π']    Σ,Δ'_d,∅ ⊢ d →↑ d',Δ''_d
//     Δ_b ⊢ b ⇝ b'[active = false],Δ'_b
//   ─────────────────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s,Δ''
//
// REFINEMENT R23 as in PTrans1. REFINEMENT R12: the barrier forgets its arrivals (BDeact), so that a second round waits
// for all ports again.
template <Recorder R>
bool PTrans2(Step<R>& step, StateId s) {
  auto rule = step.apply(Rule::PTrans2, s);
  Active(step, s);
  evaluate_actions(step, s);
  for (const BarrierId b : take_active_barriers(step, s)) {
    const std::vector<StateId>& out = step.program[b].to;
    ResolvedDestinations<R> destinations(step, out);
    for (const StateId d : out) {
      destinations.add_premises(d);
      activate(step, destination(step.program, d), kNoPort);
    }
    BDeact(step, b, 12);
  }
  return true;
}

template <Recorder R>
Rule micro_transition(Step<R>& step, StateId s);

// SProp (3.30): actions, then every active child takes its micro transition.
//
//   Δ ⊢ s.active ⇝ true    ∀ a_i ∈ s.actions, i = 1..n: Σ,Δ^{i-1} ⊢ a_i ⇝ a_i,Δ^i → Δ'
//   ∀ c ∈ active_states(Δ',s): Σ,Δ_c ⊢ c → c',Δ'_c
//   ───────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ s → s,Δ''
//
// OPTIMIZATION: in line, as most states take it.
template <Recorder R>
[[gnu::always_inline]] inline bool SProp(Step<R>& step, StateId s) {
  auto rule = step.apply(Rule::SProp, s);
  Active(step, s);
  evaluate_actions(step, s);
  for_each_active_state(step, s, [&](StateId c) { micro_transition(step, c); });
  return true;
}

template <Recorder R>
struct MicroRule {
  Rule name;
  bool (*can_apply)(const Live& state);     // a premise that is quick to check; `apply` requires it
  bool (*apply)(Step<R>& step, StateId s);  // false: the rule does not apply
};

/// The rules for a state: the first that applies is taken.
template <Recorder R>
inline constexpr std::array kMicroRules = {
    MicroRule<R>{Rule::PTrigger, [](const Live& s) { return s.reevaluating; }, PTrigger<R>},
    MicroRule<R>{Rule::PTrans1, [](const Live& s) { return !s.active_ports.empty(); }, PTrans1<R>},
    MicroRule<R>{Rule::PTrans2, [](const Live& s) { return !s.active_barriers.empty(); }, PTrans2<R>},
    MicroRule<R>{Rule::SProp, [](const Live&) { return true; }, SProp<R>},
};

template <Recorder R, std::size_t number>
[[gnu::always_inline]] inline bool try_rule(Step<R>& step, StateId s, Rule& applied) {
  constexpr MicroRule<R> rule = kMicroRules<R>[number];
  applied = rule.name;
  return rule.can_apply(step.live(s)) && rule.apply(step, s);
}

/// Applies the first rule of the table that applies. Returns its name.
/// OPTIMIZATION: a loop over the table that is unrolled, so that the rules are called directly.
template <Recorder R, std::size_t... number>
[[gnu::always_inline]] inline Rule apply_first(Step<R>& step, StateId s, std::index_sequence<number...>) {
  Rule applied;
  (void)(try_rule<R, number>(step, s, applied) || ...);
  return applied;
}

/// → of an active state: its micro transition in this micro step. Returns the rule that applied.
template <Recorder R>
Rule micro_transition(Step<R>& step, StateId s) {
  begin_visit(step, s);
  return apply_first(step, s, std::make_index_sequence<kMicroRules<R>.size()>());
}

// Micro (3.31): the micro transition of the root is that of the model.
//
//   Σ,Δ ⊢ s_root → s'_root,Δ'
//   ─────────────────────────
//   Σ ⊢ Δ ⟹ Δ'
//
// REFINEMENT R13: the very first micro step activates the root, with the arguments of the run for its parameters.
template <Recorder R>
void Micro(Step<R>& step, const std::vector<Value>& arguments) {
  auto rule = step.apply(Rule::Micro, Program::root);
  if (step.run.started) {
    visit_active_states(step, [&](StateId s) { return micro_transition(step, s) == Rule::SProp; });
    return;
  }
  rule.refinement(13);
  for (std::uint32_t i = 0; i < arguments.size(); ++i)
    Resolve(step, Program::root, i, arguments[i].is_unknown() ? nullptr : &arguments[i]);
  SAct1(step, Program::root, kNoPort);
  step.run.started = true;
}

}  // namespace race::semantics
