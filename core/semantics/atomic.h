// The atomic layer (thesis 3.4.2), semantic values: reading and changing `active`, `activated` and parameters.
// evaluation.h has its conditions, functions and actions.
#pragma once

#include "core/semantics/traversal.h"

namespace race::semantics {

// Active (3.8): whether a state, barrier or port is active.
//
//   ──────────────────────────────
//   Δ ⊢ x.active ⇝ {true, false}
template <Recorder R, typename Node>
bool Active(Step<R>& step, Node x) {
  const bool active = step.is_active(x);
  step.conclude(Rule::Active, x, kNoPort, active);
  return active;
}

// Act (3.9): a state, barrier or port becomes active.
//
//   Δ ⊢ x.active ⇝ false
//   ─────────────────────────────
//   Δ ⊢ x ⇝ x'[active = true],Δ'[Φ']
template <Recorder R, typename Node>
void Act(Step<R>& step, Node x) {
  auto rule = step.apply(Rule::Act, x);
  step.set_active(x);
}

// Deact (3.10): a state, barrier or port becomes inactive.
//
//   Δ ⊢ x.active ⇝ true
//   ──────────────────────────────
//   Δ ⊢ x ⇝ x'[active = false],Δ'[Φ']
template <Recorder R, typename Node>
void Deact(Step<R>& step, Node x) {
  auto rule = step.apply(Rule::Deact, x);
  step.set_inactive(x);
}

// BIn (3.11): an inbound port arrives at a barrier.
//
//   p ∈ b.in
//   ──────────────────────────────────
//   Δ,p ⊢ b ⇝ b'[activated ∪= p],Δ'[Φ']
template <Recorder R>
void BIn(Step<R>& step, BarrierId b, PortId p) {
  auto rule = step.apply(Rule::BIn, b, p);
  step.add_arrival(b, p);
}

// Activated (3.12): whether an inbound port has arrived at a barrier.
//
//   ──────────────────────────────────────
//   Δ,p ⊢ b.activated(p) ⇝ {true, false}
template <Recorder R>
bool Activated(Step<R>& step, BarrierId b, PortId p) {
  const bool arrived = step.has_arrived(p);
  step.conclude(Rule::Activated, b, p, arrived);
  return arrived;
}

/// The value that a parameter of `s` gets. REFINEMENT R4: a fault if it has none.
template <Recorder R>
Value resolved_value(Step<R>& step, StateId s, const ParameterInfo& pa) {
  Value value = pa.value ? *pa.value : pa.from ? step.value(pa.from, step.program[s].parent, s) : Value::unknown();
  const std::string& path = step.program[s].path;
  if (value.is_unknown())
    step.raise({language::FaultKind::unresolved, "parameter " + pa.name + " of " + path + " has no value", {}}, s);
  if (!value.is_finite())
    step.raise({language::FaultKind::value, "parameter " + pa.name + " of " + path + " is not finite", {}}, s);
  return value;
}

// Resolve (3.13): a parameter of `s` gets its value, by its expression in the scope of the parent.
//
//   ─────────────────────
//   Δ ⊢ pa.expr ⇝ c ∈ C
//
// REFINEMENT R13: an argument of the run stands for the expression of a parameter of the root.
template <Recorder R>
void Resolve(Step<R>& step, StateId s, std::uint32_t parameter, const Value* argument = nullptr) {
  const StateInfo& info = step.program[s];
  step.recorder.turn(s, parameter);
  Value c = argument ? *argument : resolved_value(step, s, info.parameters[parameter]);
  auto rule = step.apply(Rule::Resolve, s);
  rule.resolved(parameter, c);
  step.environment.write(info.first_parameter + parameter, std::move(c));
}

/// ∀ pa ∈ s.parameters, in order.
template <Recorder R>
void resolve_parameters(Step<R>& step, StateId s) {
  const auto count = static_cast<std::uint32_t>(step.program[s].parameters.size());
  for (std::uint32_t parameter = 0; parameter < count; ++parameter) Resolve(step, s, parameter);
}

}  // namespace race::semantics
