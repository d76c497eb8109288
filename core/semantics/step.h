// Step: one micro step in progress. It gives the rules what their premises need: Δ and Σ, the evaluation of conditions
// and functions, a log to discard the step by, and the recorder of its derivation.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/language/evaluate/interpreter.h"
#include "core/semantics/context.h"
#include "core/semantics/derivation.h"
#include "core/semantics/environment.h"
#include "core/semantics/program.h"

namespace race::semantics {

/// R4: thrown inside of a micro step only, caught where it is discarded (Run). Unwinding is the one place of this room
/// where an exception is clearer than a returned error: it leaves any depth of rules at once.
struct FaultSignal {
  language::Fault fault;
  Flag at;
};

/// A call that was made, and the record of its caller's call before it, with its place among the others.
struct LoggedCall {
  OperationId operation = kNone;
  std::size_t place = 0;
  std::optional<CallRecord> before;
};

/// What stood where before, oldest first.
/// OPTIMIZATION: a vector that never shrinks, so that adding is a store in line.
template <typename Place, typename Old>
class Log {
 public:
  void add(Place place, Old old) {
    if (size_ == entries_.size()) grow();
    entries_[size_++] = {place, old};
  }
  void clear() { size_ = 0; }
  auto begin() const { return entries_.begin(); }
  auto end() const { return entries_.begin() + static_cast<std::ptrdiff_t>(size_); }

 private:
  [[gnu::noinline]] void grow() { entries_.resize(2 * size_ + 16); }
  std::vector<std::pair<Place, Old>> entries_;
  std::size_t size_ = 0;
};

/// The changes of a micro step, for discarding it.
struct StepLog {
  ValueLog values;
  Log<Flag, std::uint8_t> flags;
  Log<PortId, std::uint8_t> arrived;
  Log<PortId, std::uint64_t> triggered;
  std::vector<LoggedCall> calls;
  void clear() {
    values.clear();
    flags.clear();
    arrived.clear();
    triggered.clear();
    calls.clear();
  }
  /// Gives back what can be seen of a run: Π, Ξ, Λ, Φ, arrivals, calls and their responses, what R9 holds back. The
  /// lists and marks below the rules stay: the run does not go on.
  void undo(RunState& run);
};

/// What a run keeps between micro steps so that none of it is allocated again.
struct Workspace {
  StepLog log;
  std::vector<OutgoingCall> outgoing;  // of the micro step
  std::vector<PortId> ports;           // the list of a PTrans1
  std::vector<BarrierId> barriers;     // the list of a PTrans2
};

template <Recorder R>
class Step {
 public:
  Step(const Program& p, RunState& r, Workspace& w, StepEnvironment& e, language::Interpreter& i, R& rec)
      : program(p), run(r), work(w), environment(e), interpreter(i), recorder(rec) {
    if constexpr (R::kTree) {
      environment.trace = &recorder.evaluation;
      environment.record = &recorder.evaluation;
    }
  }
  ~Step() {
    environment.trace = nullptr;
    environment.record = nullptr;
  }
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  /// Opens a node of the derivation; its premises are recorded until it goes out of scope.
  template <typename Node>
  OpenNode<R> apply(Rule rule, Node at, PortId port = kNoPort) {
    return OpenNode<R>(recorder, rule, program.flag(at), port);
  }

  /// A conclusion without premises that says whether it holds.
  template <typename Node>
  void conclude(Rule rule, Node at, PortId port, bool holds) {
    if constexpr (R::kTree) {
      DerivationNode& node = recorder.derivation.nodes.emplace_back();
      node.at = program.flag(at);
      node.port = port;
      node.rule = rule;
      node.value = holds ? NodeValue::yes : NodeValue::no;
    } else if constexpr (R::kRecords) {
      recorder.names.push_back(rule);
    }
  }

  Live& live(StateId s) { return run.live[index(s)]; }
  bool is_active(StateId s) const { return run.flags[program.flag(s)] != 0; }
  bool is_active(BarrierId b) const { return run.flags[program.flag(b)] != 0; }
  bool is_active(PortId p) const { return run.flags[program.flag(p)] != 0; }

  /// Sets an entry of Φ and tells those who read it. `owner`: the state that a Reader::kOwner is.
  [[gnu::always_inline]] void set_flag(Flag flag, bool on, StateId owner, StateId parent) {
    work.log.flags.add(flag, run.flags[flag]);
    run.flags[flag] = on ? 1 : 0;
    if (const std::uint8_t readers = program.flag_readers[flag]) tell(readers, owner, parent);
  }
  /// An arrival of `p` at its barrier comes or goes. Requires a change.
  void set_arrived(PortId p, bool on) {
    run.arrivals[program[p].to.number] += on ? 1U : ~0U;
    work.log.arrived.add(p, run.arrived[index(p)]);
    run.arrived[index(p)] = on ? 1 : 0;
  }

  /// Evaluates a condition in the scope of `s`.
  language::Truth truth(const Code& condition, StateId s, bool sees_occurrence) {
    environment.enter(s, sees_occurrence);
    if constexpr (R::kTree) recorder.evaluation.clear();
    const language::Truth value = interpreter.condition(condition, environment);
    if (value == language::Truth::fault) raise_fault(s);
    return value;
  }

  /// OPTIMIZATION: the same without what record_condition needs: most conditions are not fulfilled and not recorded.
  language::Truth untraced(const Code& condition, StateId s, bool sees_occurrence) {
    if constexpr (R::kTree) environment.trace = nullptr;
    environment.enter(s, sees_occurrence);
    const language::Truth value = interpreter.condition(condition, environment);
    if constexpr (R::kTree) environment.trace = &recorder.evaluation;
    if (value == language::Truth::fault) raise_fault(s);
    return value;
  }

  /// Executes a function in the scope of `s`: its writes and calls take effect, unless it is unmet (false).
  bool execute(const Code& function, StateId s);

  [[noreturn]] void raise(language::Fault fault, Flag at) { throw FaultSignal{std::move(fault), at}; }

  /// The fault that the last evaluation, in the scope of `s`, ended with.
  [[noreturn, gnu::noinline, gnu::cold]] void raise_fault(StateId s) { raise(interpreter.fault(), program.flag(s)); }

  /// The condition of a port or action of `s` that was evaluated last becomes a node.
  void record_condition(StateId s, PortId port, std::uint32_t action, language::Truth value) {
    if constexpr (R::kTree) {
      OpenNode<R> node = apply(Rule::Cond, s, port);
      node.node().action = action;
      node.node().value = node_value(value);
      if (value == language::Truth::unknown) node.refinement(2);
      record_evaluation(node.node(), s, 0);
    } else if constexpr (R::kRecords) {
      recorder.names.push_back(Rule::Cond);
    }
  }

  /// Discards recorded nodes from `mark` on: of attempts that did not become a rule.
  std::size_t mark() const {
    if constexpr (R::kTree) return recorder.derivation.nodes.size();
    if constexpr (R::kRecords && !R::kTree) return recorder.names.size();
    return 0;
  }
  void forget(std::size_t mark) {
    if constexpr (R::kTree) recorder.derivation.nodes.resize(mark);
    if constexpr (R::kRecords && !R::kTree) recorder.names.resize(mark);
  }

  const Program& program;
  RunState& run;
  Workspace& work;
  StepEnvironment& environment;
  language::Interpreter& interpreter;
  R& recorder;
  /// R14: whether this micro step changed Δ, `executed` or `triggered`.
  bool changed = false;

 private:
  [[gnu::noinline]] void tell(std::uint8_t readers, StateId owner, StateId parent) {
    if (readers & kOwner) wake(run, owner);
    if (readers & kParent) wake(run, parent);
  }
  // `node` moves when its premises are added: it is not touched after that.
  void record_evaluation(DerivationNode& node, StateId s, std::size_t first_call) {
    if constexpr (R::kTree) {
      Derivation& d = recorder.derivation;
      node.required = static_cast<std::uint32_t>(d.required.size());
      node.required_count = static_cast<std::uint16_t>(recorder.evaluation.required.size());
      d.required.insert(d.required.end(), recorder.evaluation.required.begin(), recorder.evaluation.required.end());
      for (const EvaluationRecord::Part& part : recorder.evaluation.parts) {
        DerivationNode premise{.at = program.flag(s), .rule = part.rule, .value = part.value};
        if (part.rule == Rule::FuncSC) {
          premise.detail = static_cast<std::uint32_t>(d.calls.size());
          d.calls.push_back(work.outgoing[first_call + part.call]);
        }
        d.nodes.push_back(premise);
      }
    }
  }
  void commit_calls(StateId s);

 public:
  /// Func (4.16) as a node: the function that was executed last. `first_call` = size of work.outgoing before it.
  void record_function(StateId s, FunctionOf of, std::uint32_t action, std::size_t first_call) {
    if constexpr (R::kTree) {
      OpenNode<R> node = apply(Rule::Func, s);
      node.node().of = of;
      node.node().action = action;
      record_evaluation(node.node(), s, first_call);
    } else if constexpr (R::kRecords) {
      recorder.names.push_back(Rule::Func);
    }
  }
};

template <Recorder R>
bool Step<R>::execute(const Code& function, StateId s) {
  environment.enter(s, true);
  environment.calls.clear();
  if constexpr (R::kTree) recorder.evaluation.clear();
  const std::size_t before = work.log.values.size();
  const auto outcome = interpreter.function(function, environment);
  if (outcome == language::Interpreter::Outcome::fault) raise_fault(s);
  if (outcome == language::Interpreter::Outcome::unmet) {
    for (ValueLog& log = work.log.values; log.size() > before; log.pop_back())
      run.values[log.back().first] = std::move(log.back().second);
    environment.calls.clear();
    return false;
  }
  if (!environment.calls.empty()) commit_calls(s);
  return true;
}

// FuncSC (4.14): the calls of a completed function get their numbers; the responses to the caller's older calls of the
// same operations are gone (R6). REFINEMENT R16: they are sent when the micro step is complete.
template <Recorder R>
void Step<R>::commit_calls(StateId s) {
  for (BufferedCall& call : environment.calls) {
    const std::uint64_t number = ++run.call_count;
    LoggedCall logged{call.operation, 0, std::nullopt};
    std::vector<CallRecord>& records = run.calls[call.operation];
    const std::string whose = program.services.is_open(call.operation) ? call.service : std::string();
    const auto old = std::ranges::find_if(
        records, [&](const CallRecord& record) { return record.caller == s && record.service == whose; });
    if (old != records.end()) {
      logged.place = static_cast<std::size_t>(old - records.begin());
      logged.before = std::move(*old);
      records.erase(old);
    }
    records.push_back({s, whose, number});
    wake_response_readers(run, program, call.operation);
    work.log.calls.push_back(std::move(logged));
    work.outgoing.push_back({number, call.operation, std::move(call.service), std::move(call.name),
                             std::move(call.args), std::move(call.kwargs), s});
  }
  environment.calls.clear();
}

}  // namespace race::semantics
