// Step: one micro step in progress. It gives the rules what their premises need: the contexts (StepContext), the
// evaluation of conditions and functions, the recorder of the derivation, and the order of ports, actions and children.
#pragma once

#include <span>
#include <utility>

#include "core/language/evaluate/interpreter.h"
#include "core/semantics/order.h"
#include "core/semantics/recorder.h"
#include "core/semantics/step_context.h"

namespace race::semantics {

/// R4: thrown inside of a micro step only, caught where it is discarded (Run). Unwinding is the one place of this room
/// where an exception is clearer than a returned error: it leaves any depth of rules at once.
struct FaultSignal {
  language::Fault fault;
  Flag at;
};

template <Recorder R>
class Step : public StepContext {
 public:
  Step(const Program& p, RunState& r, Workspace& w, StepEnvironment& e, language::Interpreter& i, R& rec,
       const Order& o)
      : StepContext(p, r, w), environment(e), recorder(rec), order(o), interpreter_(i) {
    if (R::kTraces) environment.trace = &environment.evaluation;
  }
  ~Step() { environment.trace = nullptr; }

  /// Opens a node of the derivation; its premises are recorded until it goes out of scope.
  template <typename Node>
  auto apply(Rule rule, Node at, PortId port = kNoPort) {
    return recorder.open(rule, program.flag(at), port);
  }
  auto apply(Rule rule, PortId p) { return recorder.open(rule, program.flag(program[p].state), p); }
  /// `a`: an action of `s`, or kNone.
  auto apply(Rule rule, StateId s, ActionId a) {
    return recorder.open(rule, program.flag(s), kNoPort, a == kNone ? kNone : a - program[s].actions.low);
  }
  /// A conclusion without premises that says whether it holds.
  template <typename Node>
  void conclude(Rule rule, Node at, PortId port, bool holds) {
    recorder.add(rule, program.flag(at), port, holds);
  }

  /// Evaluates a condition in the scope of `s`; condition_parts() has its parts then.
  language::Truth truth(const Code& condition, StateId s, bool sees_occurrence) {
    environment.enter(s, sees_occurrence);
    if (R::kTraces) environment.evaluation.clear();
    const language::Truth value = interpreter_.condition(condition, environment);
    if (value == language::Truth::fault) raise_fault(s);
    return value;
  }
  /// OPTIMIZATION: the same without its parts: most conditions are not fulfilled, and not shown in a derivation.
  language::Truth untraced_truth(const Code& condition, StateId s, bool sees_occurrence) {
    if (R::kTraces) environment.trace = nullptr;
    environment.enter(s, sees_occurrence);
    const language::Truth value = interpreter_.condition(condition, environment);
    if (R::kTraces) environment.trace = &environment.evaluation;
    if (value == language::Truth::fault) raise_fault(s);
    return value;
  }
  /// For a derivation, evaluates a condition again whose parts are not known.
  void trace(const Code& condition, StateId s, bool sees_occurrence) {
    if (R::kTraces) truth(condition, s, sees_occurrence);
  }
  /// The parts of the condition that was evaluated last, in order; none without a derivation.
  std::span<const ConditionPart> condition_parts() const { return environment.evaluation.parts; }

  /// Executes a function in the scope of `s`: its writes take effect, unless it is unmet (false). executed_statements()
  /// has what it did, its calls among them.
  bool execute(const Code& function, StateId s);
  /// The statements of the function that was executed last, in order; without a derivation, its calls alone.
  std::span<const Statement> executed_statements() const { return environment.evaluation.statements; }

  /// The value of an expression in the scope of `s`; a fault is `owner`'s.
  Value value(const Code& expression, StateId s, StateId owner) {
    environment.enter(s, false);
    auto value = interpreter_.expression(expression, environment);
    if (!value) raise_fault(owner);
    if (!environment.take_use(interpreter_.work())) [[unlikely]]
      raise_over_budget(owner);
    return std::move(*value);
  }

  [[noreturn]] void raise(language::Fault fault, StateId s) { throw FaultSignal{std::move(fault), program.flag(s)}; }
  /// The fault that the last evaluation, in the scope of `s`, ended with.
  [[noreturn, gnu::noinline, gnu::cold]] void raise_fault(StateId s) { raise(interpreter_.fault(), s); }
  /// A budget of the macro step is exceeded.
  [[noreturn, gnu::noinline, gnu::cold]] void raise_over_budget(StateId s) {
    raise({language::FaultKind::budget, environment.exceeded_budget(), {}}, s);
  }
  /// R4: an entry or exit function of `s` was unmet.
  [[noreturn, gnu::noinline, gnu::cold]] void raise_unmet(StateId s) {
    language::Fault fault = interpreter_.fault();
    fault.kind = language::FaultKind::unmet;
    raise(std::move(fault), s);
  }

  StepEnvironment& environment;
  R& recorder;
  const Order& order;  // declared unless R::kVisitsAll

 private:
  language::Interpreter& interpreter_;
};

template <Recorder R>
bool Step<R>::execute(const Code& function, StateId s) {
  environment.enter(s, true);
  environment.clear_calls();
  environment.evaluation.clear();
  const std::size_t before = work.log.values.size(), printed_before = environment.printed.size();
  const std::uint64_t output_before = environment.use.output_units;
  const auto outcome = interpreter_.function(function, environment);
  if (outcome == language::Interpreter::Outcome::fault) raise_fault(s);
  if (outcome == language::Interpreter::Outcome::done) {
    if (!environment.take_use(interpreter_.work())) [[unlikely]]
      raise_over_budget(s);
    return true;
  }
  for (ValueLog& log = work.log.values; log.size() > before; log.pop_back())
    run.values[log.back().first] = std::move(log.back().second);
  environment.clear_calls();
  environment.printed.resize(printed_before);
  environment.use.output_units = output_before;
  return false;
}

}  // namespace race::semantics
