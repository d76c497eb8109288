// The atomic layer (thesis 3.4.2, with service interaction 4.4): reading and changing single semantic values,
// conditions, functions, actions. Below the rules stand the lists that say which children are active.
#pragma once

#include "core/semantics/step.h"

namespace race::semantics {

// Active (3.8):   Δ ⊢ x.active ⇝ {true, false}
template <Recorder R, typename Node>
bool Active(Step<R>& step, Node x) {
  const bool active = step.is_active(x);
  step.conclude(Rule::Active, x, kNoPort, active);
  return active;
}

// Act (3.9):   Δ ⊢ x.active ⇝ false   ⟹   Δ ⊢ x ⇝ x'[active = true], Δ'[Φ']
template <Recorder R>
void Act(Step<R>& step, StateId s) {
  const StateId parent = step.program[s].parent;
  step.apply(Rule::Act, s);
  step.set_flag(step.program.flag(s), true, s, parent);
  Live& live = step.live(s);
  // OPTIMIZATION: in this macro step its ports see no occurrence (R21), so one that waits for one need not look.
  if (!step.program[s].waits || step.run.small_budget) wake(step.run, s);
  live.looking = false;
  ++step.run.active_states;
  live.activated_in = step.run.epoch;
  live.activated_at = ++step.run.tick;
  live.calls_before = step.run.call_count;
  ++live.activations;
  if (parent == kNoState) return;
  // OPTIMIZATION: the active children are a list in order of declaration, which is the order of their numbers.
  Live& above = step.live(parent);
  StateId before = above.last_active;
  while (before != kNoState && index(before) > index(s)) before = step.live(before).previous;
  live.previous = before;
  live.next = before == kNoState ? above.first_active : step.live(before).next;
  (before == kNoState ? above.first_active : step.live(before).next) = s;
  (live.next == kNoState ? above.last_active : step.live(live.next).previous) = s;
  if (!live.touched) {
    live.touched = true;
    above.touched_children.push_back(s);
  }
}

template <Recorder R>
void Act(Step<R>& step, BarrierId b) {
  const StateId parent = step.program[b].parent;
  step.apply(Rule::Act, b);
  step.set_flag(step.program.flag(b), true, parent, parent);
  step.live(parent).open.push_back(b);
  step.run.hot.add(parent);
}

// An active port of `s` without destination, or of the root, stays active until its state is activated again or its
// parent is deactivated.
template <Recorder R>
void Act(Step<R>& step, PortId p) {
  const PortInfo& info = step.program[p];
  const StateId parent = step.program[info.state].parent;
  OpenNode<R> node = step.apply(Rule::Act, info.state, p);
  step.set_flag(step.program.flag(p), true, info.state, parent);
  if (parent == kNoState) return;
  Live& above = step.live(parent);
  (info.to ? above.pending : above.lingering).push_back(p);
  if (info.to) step.run.hot.add(parent);
}

// Deact (3.10):   Δ ⊢ x.active ⇝ true   ⟹   Δ ⊢ x ⇝ x'[active = false], Δ'[Φ']
template <Recorder R>
void Deact(Step<R>& step, StateId s) {
  const StateId parent = step.program[s].parent;
  step.apply(Rule::Deact, s);
  step.set_flag(step.program.flag(s), false, s, parent);
  --step.run.active_states;
  if (parent == kNoState) return;
  const Live& live = step.live(s);
  Live& above = step.live(parent);
  (live.previous == kNoState ? above.first_active : step.live(live.previous).next) = live.next;
  (live.next == kNoState ? above.last_active : step.live(live.next).previous) = live.previous;
}

// The lists of the parent that hold an open barrier or an active port are emptied by those who walk them.
template <Recorder R>
void Deact(Step<R>& step, BarrierId b) {
  const StateId parent = step.program[b].parent;
  step.apply(Rule::Deact, b);
  step.set_flag(step.program.flag(b), false, parent, parent);
}

template <Recorder R>
void Deact(Step<R>& step, PortId p) {
  const StateId s = step.program[p].state;
  OpenNode<R> node = step.apply(Rule::Deact, s, p);
  if (step.is_active(p)) step.set_flag(step.program.flag(p), false, s, step.program[s].parent);
}

// BIn (3.11):   p ∈ b.in   ⟹   Δ, p ⊢ b ⇝ b'[activated ∪= p], Δ'[Φ']
template <Recorder R>
void BIn(Step<R>& step, BarrierId b, PortId p) {
  OpenNode<R> node = step.apply(Rule::BIn, b, p);
  Live& above = step.live(step.program[b].parent);
  if (std::ranges::find(above.waiting, b) == above.waiting.end()) above.waiting.push_back(b);
  if (!step.run.arrived[index(p)]) step.set_arrived(p, true);
}

// Activated (3.12):   Δ, p ⊢ b.activated(p) ⇝ {true, false}
template <Recorder R>
bool Activated(Step<R>& step, BarrierId b, PortId p) {
  const bool arrived = step.run.arrived[index(p)] != 0;
  step.conclude(Rule::Activated, b, p, arrived);
  return arrived;
}

// Resolve (3.13):   Δ ⊢ pa.expr ⇝ c ∈ C
// Gives a parameter of `s` its value, in the scope of the parent. A fault `unresolved` if it has none.
template <Recorder R>
void Resolve(Step<R>& step, StateId s, std::uint32_t parameter) {
  const StateInfo& info = step.program[s];
  const ParameterInfo& pa = info.parameters[parameter];
  const Slot slot = info.parameter_slot + parameter;
  Value value = Value::unknown();
  if (pa.value) {
    value = *pa.value;
  } else if (pa.from) {
    step.environment.enter(info.parent, false);
    auto resolved = step.interpreter.expression(pa.from, step.environment);
    if (!resolved) step.raise(step.interpreter.fault(), step.program.flag(s));
    value = std::move(*resolved);
  }
  if (value.is_unknown())
    step.raise({language::FaultKind::unresolved, "parameter " + pa.name + " of " + info.path + " has no value", {}},
               step.program.flag(s));
  if (!value.is_finite())
    step.raise({language::FaultKind::value, "parameter " + pa.name + " of " + info.path + " is not finite", {}},
               step.program.flag(s));
  OpenNode<R> node = step.apply(Rule::Resolve, s);
  if constexpr (R::kTree) {
    node.node().detail = static_cast<std::uint32_t>(step.recorder.derivation.resolved.size());
    step.recorder.derivation.resolved.push_back({parameter, value});
  }
  step.environment.write(slot, std::move(value));
}

template <Recorder R>
void resolve_parameters(Step<R>& step, StateId s) {
  const auto count = static_cast<std::uint32_t>(step.program[s].parameters.size());
  for (std::uint32_t parameter = 0; parameter < count; ++parameter) Resolve(step, s, parameter);
}

// Func (4.16) for an entry or exit function. REFINEMENT R4: unmet is a fault.
template <Recorder R>
void Func(Step<R>& step, StateId s, const Code& function, FunctionOf of) {
  if (!function) return;
  const std::size_t first_call = step.work.outgoing.size();
  if (!step.execute(function, s)) {
    language::Fault fault = step.interpreter.fault();
    fault.kind = language::FaultKind::unmet;
    step.raise(std::move(fault), step.program.flag(s));
  }
  step.record_function(s, of, kNone, first_call);
}

// REFINEMENT R19: whether something that lets the action run again has come since it ran.
template <Recorder R>
bool delivered_anew(Step<R>& step, StateId s, ActionId a) {
  const std::uint64_t served = step.run.served[a];
  if (served == 0 || step.live(s).activated_at > served) return true;
  const ActionInfo& action = step.program.actions[a];
  return std::ranges::any_of(action.events, [&](EventId e) { return step.run.event_tick[e] > served; }) ||
         std::ranges::any_of(action.responses, [&](OperationId o) { return step.run.response_tick[o] > served; });
}

// Action1 (4.17): executed(Σ, a) ⇝ false, a.cond ⇝ true   ⟹   a.func, Σ'[executed ∪= a]
// Action2 (3.17): executed(Σ, a) ⇝ true                   ⟹   nothing
// Action3 (4.18): a.cond ⇝ false                          ⟹   nothing
// OPTIMIZATION: out of line, so that states without actions pay nothing for it.
template <Recorder R>
[[gnu::noinline]] void Action(Step<R>& step, StateId s, ActionId a) {
  const ActionInfo& action = step.program.actions[a];
  const std::uint32_t number = a - step.program[s].actions.low;
  const auto look_again = [&] {  // in the next macro step, when `executed` is empty
    if (step.live(s).recheck) return;
    step.live(s).recheck = true;
    step.run.recheck.push_back(s);
  };
  const auto Action2 = [&](Refinement refinement) {
    OpenNode<R> node = step.apply(Rule::Action2, s);
    if constexpr (R::kTree) node.node().action = number;
    node.refinement(refinement);
  };
  if (step.run.executed[a] == step.run.epoch) {
    look_again();
    return Action2(0);
  }
  const bool held = action.served && !delivered_anew(step, s, a);
  if (held && !action.level) return Action2(19);

  const std::size_t mark = step.mark();
  OpenNode<R> node = step.apply(Rule::Action3, s);
  if constexpr (R::kTree) node.node().action = number;
  const language::Truth cond = step.truth(action.when, s, true);
  step.record_condition(s, kNoPort, number, cond);
  if (cond != language::Truth::yes) {
    if (action.level) step.run.served[a] = 0;
    return;
  }
  if (held) {  // the level has not fallen since the action ran; this node becomes an Action2 without premise
    if constexpr (R::kTree) {
      step.recorder.derivation.nodes.resize(mark + 1);
      step.recorder.derivation.nodes[mark].rule = Rule::Action2;
      node.refinement(19);
    } else {
      step.forget(mark);
      if constexpr (R::kRecords) step.recorder.names.push_back(Rule::Action2);
    }
    return;
  }
  const std::size_t first_call = step.work.outgoing.size();
  if (!step.execute(action.code, s)) {  // REFINEMENT R3: unmet, it does not execute
    node.refinement(3);
    return;
  }
  if constexpr (R::kTree) node.node().rule = Rule::Action1;
  if constexpr (R::kRecords && !R::kTree) step.recorder.names[mark] = Rule::Action1;
  step.record_function(s, FunctionOf::action, number, first_call);
  step.run.executed[a] = step.run.epoch;
  step.run.served[a] = ++step.run.tick;
  step.changed = true;
  look_again();
}

/// All actions of `s`, in order: a premise of the micro rules.
template <Recorder R>
inline void actions_of(Step<R>& step, StateId s) {
  if (!R::kRecords && !step.live(s).looking) return;
  for (const ActionId a : step.program[s].actions) Action(step, s, a);
}

}  // namespace race::semantics
