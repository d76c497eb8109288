// Machine: evaluates a Program. A result is a reference if the value is stored somewhere (a slot, a local, a constant,
// data of an event), so that reading needs no reference count; a computed value goes into the caller's `out`.
//
// Unknown and faults are both returned as the value `unknown`; `stopped_` distinguishes them. In a function (`strict_`)
// reading something unknown stops the evaluation, except within available().
#pragma once

#include <algorithm>

#include "core/language/compile/program.h"
#include "core/language/evaluate/interpreter.h"
#include "core/language/library/functions.h"
#include "core/language/values/values.h"

namespace race::language {

// The arguments of one call on the stack; removes them at the end of the scope.
class ArgumentScope {
 public:
  explicit ArgumentScope(std::vector<Value>& stack) : stack_(stack), base_(stack.size()) {}
  ~ArgumentScope() { stack_.resize(base_); }
  ArgumentScope(const ArgumentScope&) = delete;
  ArgumentScope& operator=(const ArgumentScope&) = delete;
  Arguments arguments() const { return Arguments(stack_).subspan(base_); }

 private:
  std::vector<Value>& stack_;
  std::size_t base_;
};

class Machine {
 public:
  explicit Machine(Interpreter::Limits limits) : limits_(limits), stop_(limits.stop ? *limits.stop : kNever) {
    context_.value_units = limits.value_units;
    context_.steps = limits.steps;
  }

  Truth condition(const Program& program, Environment& environment);
  std::optional<Value> expression(const Program& program, Environment& environment);
  Interpreter::Outcome function(const Program& program, Environment& environment);
  const Fault& fault() const { return context_.fault; }
  /// Units of work of the last evaluation; at most the budget.
  std::uint64_t work() const {
    return limits_.steps - static_cast<std::uint64_t>(std::max<std::int64_t>(context_.left, 0));
  }

  // For explanations: one part of a condition, evaluated alone with a budget of its own.
  Truth part(const Program& program, Environment& environment, NodeId node);
  Value value(const Program& program, Environment& environment, NodeId node);  // unknown after a fault

 private:
  enum class Flow : std::uint8_t { next, break_loop, continue_loop, halt };

  // evaluate.cpp: references and operators
  void begin(const Program& program, Environment& environment, bool strict);
  bool is_told_to_stop() const;
  bool take_unit();
  [[gnu::noinline, gnu::cold]] void fail_over_budget(NodeId id);
  bool over_budget();  // after an evaluation: whether it exceeded its budget, or stopped
  const Value& operand(NodeId id, Value& out);
  const Value& evaluate(NodeId id, Value& out);
  Truth test(NodeId id);
  Truth test_traced(NodeId id);
  Truth compare_node(const Node& n, NodeId id);
  Truth chain(const Node& n, NodeId id);
  Truth all_of(const Node& n);
  Truth any_of(const Node& n);
  Truth truth_of(const Value& v) const;
  static const Value& from_truth(Truth truth);
  const Value& binary(const Node& n, NodeId id, Value& out);
  const Value& unary(const Node& n, NodeId id, Value& out);
  const Value& logical(const Node& n, Value& out);
  const Value& conditional(const Node& n, Value& out);
  const Value& read_local(const Node& n, NodeId id);

  // evaluate_services.cpp
  const Value& event(EventId event, NodeId id);
  const Value& event_present(EventId event, NodeId id);
  const Value& latest(EventId event, NodeId id);
  const Value& response(OperationId operation, std::string_view service, bool error, bool presence, NodeId id);
  const Value& dynamic_event(const Node& n, NodeId id);
  const Value& dynamic_response(const Node& n, NodeId id);
  const Value& available(const Node& n, Value& out);
  void require(EventId event);

  // evaluate_structures.cpp
  const Value& field(const Node& n, NodeId id, Value& out);
  const Value& index(const Node& n, NodeId id, Value& out);
  const Value& slice(const Node& n, NodeId id, Value& out);
  const Value& list(const Node& n, NodeId id, Value& out);
  const Value& dict(const Node& n, NodeId id, Value& out);
  const Value& collection(const Node& n, NodeId id, Value& out);
  const Value& comprehension(const Node& n, NodeId id, Value& out);
  bool clause(const Node& n, std::size_t number, List& made, bool& unknown);
  const Value& fstring(const Node& n, NodeId id, Value& out);
  const Value& format(const Node& n, NodeId id, Value& out);

  // evaluate_calls.cpp
  const Value& function_call(const Node& n, NodeId id, Value& out);
  const Value& method_call(const Node& n, NodeId id, Value& out);
  const Value& mutate(const Node& n, NodeId id, Value& out);
  const Value& invalid_call(const Node& n, NodeId id);
  bool arguments(const std::uint32_t* run, std::size_t count);
  const Method::Overload* find_overload(const Method& method, const Value& object, std::size_t given, NodeId id);

  // execute.cpp: statements and targets
  Flow execute(NodeId id);
  Flow block(const Node& n);
  Flow branch(const Node& n);
  Flow for_loop(const Node& n, NodeId id);
  Flow for_range(const Node& n, const Node& range);
  Flow while_loop(const Node& n);
  Flow augment(const Node& n, NodeId id);
  Flow augment_place(const Node& n, NodeId id);
  Flow call_service(const Node& n, NodeId id);
  bool store(ValueIndex slot, Value value, NodeId id);
  bool assign(NodeId target, Value value);
  bool assign_place(const Place& place, Value value, NodeId id);
  bool augmented(BinaryOperator op, Value& value, const Value& by, int levels);
  bool keys_of(const Place& place);
  Value* find(Value& root, Arguments keys, NodeId id);
  Value* root_of(const Place& place, Value& copy, NodeId id);

  // Faults.
  const Value& unknown(NodeId id);       // something that was read has no value
  const Value& locate_fault(NodeId id);  // after a fault in the Context: sets its position
  const Value& fail(FaultKind kind, std::string message, NodeId id);
  const Value& checked(Value value, NodeId id, Value& out);  // a computed value, or the fault of computing it

  static const Value kUnknown;
  static const Value kTrue;
  static const Value kFalse;

  static inline const std::atomic<bool> kNever{false};

  Interpreter::Limits limits_;
  const std::atomic<bool>& stop_;
  Context context_;
  const Program* program_ = nullptr;
  const Node* nodes_ = nullptr;
  const Value* constants_ = nullptr;
  Environment* environment_ = nullptr;
  bool strict_ = false;
  bool stopped_ = false;
  std::vector<Value> locals_;
  std::vector<Value> stack_;  // arguments of calls that are being made
};

inline bool Machine::is_told_to_stop() const { return stop_.load(std::memory_order_relaxed); }

// False: the budget has no unit left, or the evaluation is told to stop.
inline bool Machine::take_unit() { return --context_.left >= 0 && !is_told_to_stop(); }

inline const Value& Machine::read_local(const Node& n, NodeId id) {
  const Value& v = locals_[n.a];
  return v.is_unknown() ? fail(FaultKind::name, program_->locals[n.a], id) : v;
}

// OPTIMIZATION: reading a leaf is inlined. It takes its unit of the budget without a check: the next evaluation checks.
inline const Value& Machine::operand(NodeId id, Value& out) {
  const Node& n = nodes_[id];
  if (n.op == Opcode::constant) {
    --context_.left;
    return constants_[n.a];
  }
  if (n.op == Opcode::slot) {
    --context_.left;
    const Value& v = environment_->values[n.a];
    return v.is_unknown() ? unknown(id) : v;
  }
  if (n.op == Opcode::local) {
    --context_.left;
    return read_local(n, id);
  }
  return evaluate(id, out);
}

struct Interpreter::State {
  explicit State(Limits limits) : steps(limits.steps), machine(limits) {}
  std::uint64_t steps;
  Machine machine;
};

}  // namespace race::language
