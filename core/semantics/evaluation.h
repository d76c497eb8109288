// The atomic layer (thesis 3.4.2, refined in 4.4), conditions, functions and actions. The interpreter evaluates a
// condition or function as a whole and says what it came to; the rules CondBE to FuncSC are about these parts. Lookup
// (4.9) is done when code is compiled, and by the interpreter for svc[expr].
#pragma once

#include "core/semantics/atomic.h"
#include "core/semantics/attempt.h"

namespace race::semantics {

// CondBD (4.10): a part of a condition that reads data of a service.
//
//   Σ ⊢ bd.svc ⇝ svc ≠ ∅    ∀ ev ∈ bd.ev: svc.ev(ev) ≠ ∅    ∀ op ∈ bd.op: svc.op(op) ≠ ∅
//   ε = (bd.ev ∪ bd.op), get(Σ,ε) ≠ ∅
//   ─────────────────────────────────────────────────────────────────────────────────────
//   Σ ⊢ bd ⇝ε b ∈ {true, false}
//
// REFINEMENT R2: where a premise does not hold, the part is unknown.
template <Recorder R>
void CondBD(Step<R>& step, StateId s, const ConditionPart& bd) {
  step.recorder.add_part(Rule::CondBD, step.program.flag(s), bd.value);
}

// CondBE (4.11): a part of a condition that reads the model alone.
//
//   ──────────────────────────
//   Σ ⊢ be ⇝ b ∈ {true, false}
template <Recorder R>
void CondBE(Step<R>& step, StateId s, const ConditionPart& be) {
  step.recorder.add_part(Rule::CondBE, step.program.flag(s), be.value);
}

// Cond (4.12): a condition from its parts. `owner`: the port or action of `s` whose condition it is; `value`: what it
// was evaluated to.
//
//   ∀ bc_i ∈ bc, i = 1..n: Σ,Δ ⊢ bc_i ⇝ε_i b_i ∈ {true, false}
//   ───────────────────────────────────────────────────────────
//   Σ,Δ ⊢ bc ⇝ε bool(bc,b_1..b_n) ∈ {true, false}              ε = ⋃ ε_i
//
// REFINEMENT R2: the value can be unknown.
template <Recorder R, typename Owner>
void Cond(Step<R>& step, StateId s, Owner owner, language::Truth value) {
  auto rule = step.apply(Rule::Cond, s, owner);
  rule.value(value);
  if (value == language::Truth::unknown) rule.refinement(2);
  rule.required(step.environment.evaluation.required);
  for (const ConditionPart& bc : step.condition_parts()) bc.service ? CondBD(step, s, bc) : CondBE(step, s, bc);
}

// FuncSD (4.13): a statement that reads data of a service.
//
//   Σ ⊢ sd.svc ⇝ svc ≠ ∅    ∀ ev ∈ sd.ev: svc.ev(ev) ≠ ∅    ∀ op ∈ sd.op: svc.op(op) ≠ ∅
//   ε = (sd.ev ∪ sd.op), get(Σ,ε) ≠ ∅
//   ─────────────────────────────────────────────────────────────────────────────────────
//   Σ,Δ ⊢ sd ⇝ε sd,Δ'[Ξ',Λ']
template <Recorder R>
void FuncSD(Step<R>& step, StateId s) {
  step.recorder.add_part(Rule::FuncSD, step.program.flag(s));
}

// FuncSC (4.14): a statement that calls an operation of a service.
//
//   Σ ⊢ sc.svc ⇝ svc ≠ ∅    α = svc.op(sc.op) ≠ ∅    ω = channel(Ω,svc)
//   ────────────────────────────────────────────────────────────────────
//   Ω,Σ ⊢ sc ⇝ω!α sc
//
// REFINEMENT R16: it is sent when the micro step is complete. REFINEMENT R7: a call to what there is not is answered.
template <Recorder R>
void FuncSC(Step<R>& step, StateId s, BufferedCall& sc) {
  step.send(s, std::move(sc));
  step.recorder.add_call(step.program.flag(s), step.work.outgoing.back());
}

// FuncST (4.15): a statement that needs no service.
//
//   ───────────────────────
//   Σ,Δ ⊢ st ⇝ st,Δ'[Ξ',Λ']
template <Recorder R>
void FuncST(Step<R>& step, StateId s) {
  step.recorder.add_part(Rule::FuncST, step.program.flag(s));
}

// Func (4.16): a function executes its statements, in order. `a`: the action of `s` whose function it is, or kNone.
//
//   ∀ f_i ∈ f, i = 1..n: Σ,Δ^{i-1} ⊢ f_i ⇝ε_i,ω!α_i f_i,Δ^i[Ξ',Λ']    Ω^{i-1} ⊢ svc ⇝ω?α_i svc'_i,Ω^i[ε'_i]
//   ──────────────────────────────────────────────────────────────────────────────────────────────────────────
//   Ω,Σ,Δ ⊢ f ⇝ε f,Δ^n,Ω^n[ε']                                                                  ε = ⋃ ε_i
//
// Does not apply (false) if the function is unmet (R2): nothing of it takes effect then.
template <Recorder R>
bool Func(Step<R>& step, StateId s, const Code& f, FunctionOf of, ActionId a = kNone) {
  if (!step.execute(f, s)) return false;
  auto rule = step.apply(Rule::Func, s, a);
  rule.of(of);
  rule.required(step.environment.evaluation.required);
  for (const Statement& f_i : step.executed_statements()) {
    if (f_i.kind == Statement::Kind::plain) FuncST(step, s);
    if (f_i.kind == Statement::Kind::service_data) FuncSD(step, s);
    if (f_i.kind == Statement::Kind::service_call) FuncSC(step, s, step.environment.calls[f_i.call]);
  }
  step.environment.clear_calls();
  return true;
}

/// Func of the entry or exit function of `s`, if there is one. REFINEMENT R4: unmet is a fault.
template <Recorder R>
void entry_or_exit(Step<R>& step, StateId s, const Code& f, FunctionOf of) {
  if (f && !Func(step, s, f, of)) step.raise_unmet(s);
}

// Action1 (4.17): the condition is fulfilled and the action has not been executed in this macro step: it is executed.
//
//   Σ ⊢ executed(Σ,a) ⇝ false    Σ,Δ ⊢ a.cond ⇝ε_c true    Ω,Σ,Δ ⊢ a.func ⇝ε_f a.func,Δ',Ω'
//   ───────────────────────────────────────────────────────────────────────────────────────
//   Ω,Σ,Δ ⊢ a ⇝{ε_c ∪ ε_f} a,Δ',Σ'[executed ∪= a],Ω'
//
// Does not apply (false) if the function is unmet (R3).
template <Recorder R>
bool Action1(Step<R>& step, StateId s, ActionId a) {
  Attempt attempt(step.recorder);
  auto rule = step.apply(Rule::Action1, s, a);
  Cond(step, s, a, language::Truth::yes);
  if (!Func(step, s, step.program.actions[a].code, FunctionOf::action, a)) return false;
  step.set_executed(a);
  attempt.set_applies();
  return true;
}

// Action2 (3.17): the action has been executed in this macro step.
//
//   Σ ⊢ executed(Σ,a) ⇝ true
//   ────────────────────────
//   Σ ⊢ a ⇝ a
//
// REFINEMENT R19: nor is it executed again before something that it waits for is delivered anew.
template <Recorder R>
void Action2(Step<R>& step, StateId s, ActionId a, Refinement refinement) {
  auto rule = step.apply(Rule::Action2, s, a);
  rule.refinement(refinement);
}

// Action3 (4.18): the condition of the action is not fulfilled.
//
//   Σ,Δ ⊢ a.cond ⇝ε false
//   ─────────────────────
//   Σ,Δ ⊢ a ⇝ε a
//
// REFINEMENT R3: or it is, and the function is unmet.
template <Recorder R>
void Action3(Step<R>& step, StateId s, ActionId a, language::Truth cond, Refinement refinement) {
  auto rule = step.apply(Rule::Action3, s, a);
  rule.refinement(refinement);
  Cond(step, s, a, cond);
}

/// ⇝ of an action of `s`: Action1, Action2 or Action3.
/// OPTIMIZATION: out of line, so that states without actions pay nothing for it.
template <Recorder R>
[[gnu::noinline]] void evaluate_action(Step<R>& step, StateId s, ActionId a) {
  const ActionInfo& action = step.program.actions[a];
  step.recorder.turn(a);
  if (step.is_executed(a)) {
    step.recheck(s);
    return Action2(step, s, a, 0);
  }
  const bool served = action.served && !step.is_delivered_anew(s, a);
  if (served && !action.level) return Action2(step, s, a, 19);
  const language::Truth cond = step.truth(action.when, s, true);
  if (cond != language::Truth::yes) {
    if (action.level) step.clear_served(a);  // R19: it was not fulfilled; when it is again, the action runs again
    return Action3(step, s, a, cond, 0);
  }
  if (served) return Action2(step, s, a, 19);
  if (Action1(step, s, a)) return step.recheck(s);
  step.trace(action.when, s, true);
  Action3(step, s, a, cond, 3);
}

/// ∀ a ∈ s.actions, in order: a premise of the micro rules.
template <Recorder R>
[[gnu::always_inline]] inline void evaluate_actions(Step<R>& step, StateId s) {
  for (const ActionId a : actions_to_try(step, s)) evaluate_action(step, s, a);
}

}  // namespace race::semantics
