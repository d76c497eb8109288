// Evaluation: entry points, references and operators.
#include <cmath>

#include "core/language/evaluate/machine_internal.h"

namespace race::language {

const Value Machine::kUnknown = Value::unknown();
const Value Machine::kTrue = Value(true);
const Value Machine::kFalse = Value(false);

inline void Machine::begin(const Program& program, Environment& environment, bool strict) {
  program_ = &program;
  nodes_ = program.nodes.data();
  constants_ = program.constants.data();
  environment_ = &environment;
  context_.left = is_told_to_stop() ? 0 : static_cast<std::int64_t>(limits_.steps);
  strict_ = strict;
  stopped_ = false;
  context_.failed = false;
  context_.environment = &environment;
  if (!program.locals.empty()) locals_.assign(program.locals.size(), Value::unknown());
}

// OPTIMIZATION: reading a leaf takes a unit of the budget without a check, so an evaluation checks again at its end.
inline bool Machine::over_budget() {
  if (context_.left < 0) fail_over_budget(program_->root);
  return stopped_;
}

void Machine::fail_over_budget(NodeId id) {
  if (stopped_) return;
  context_.fail_over_budget();
  locate_fault(id);
}

Truth Machine::condition(const Program& program, Environment& environment) {
  begin(program, environment, false);
  const Truth truth = environment.trace == nullptr ? test(program.root) : test_traced(program.root);
  return over_budget() ? Truth::fault : truth;
}

Truth Machine::part(const Program& program, Environment& environment, NodeId node) {
  begin(program, environment, false);
  const Truth truth = test(node);
  return over_budget() ? Truth::fault : truth;
}

Value Machine::value(const Program& program, Environment& environment, NodeId node) {
  begin(program, environment, false);
  Value out;
  return evaluate(node, out);
}

std::optional<Value> Machine::expression(const Program& program, Environment& environment) {
  begin(program, environment, false);
  Value out;
  Value result = evaluate(program.root, out);
  if (!over_budget() && !result.is_unknown() && !check_storable(context_, result)) locate_fault(program.root);
  if (stopped_) return std::nullopt;
  return result;
}

Interpreter::Outcome Machine::function(const Program& program, Environment& environment) {
  begin(program, environment, true);
  execute(program.root);
  over_budget();
  if (!program.locals.empty()) locals_.clear();
  if (!stopped_) return Interpreter::Outcome::done;
  return context_.fault.kind == FaultKind::unmet ? Interpreter::Outcome::unmet : Interpreter::Outcome::fault;
}

// Faults.

const Value& Machine::unknown(NodeId id) {
  if (strict_ && !stopped_)
    fail(FaultKind::unmet, std::string(language::slice(program_->text, program_->spans[id])) + " has no value", id);
  return kUnknown;
}

const Value& Machine::fail(FaultKind kind, std::string message, NodeId id) {
  context_.fail(kind, std::move(message));
  return locate_fault(id);
}

const Value& Machine::locate_fault(NodeId id) {
  if (!stopped_) context_.fault.where = program_->range(id);
  stopped_ = true;
  return kUnknown;
}

const Value& Machine::checked(Value value, NodeId id, Value& out) {
  if (context_.failed) return locate_fault(id);
  out = std::move(value);
  return out;
}

const Value& Machine::evaluate(NodeId id, Value& out) {
  const Node& n = nodes_[id];
  if (!take_unit()) {
    fail_over_budget(id);
    return kUnknown;
  }
  switch (n.op) {
    case Opcode::constant:
      return constants_[n.a];
    case Opcode::local:
      return read_local(n, id);
    case Opcode::slot: {
      const Value& v = environment_->values[n.a];
      return v.is_unknown() ? unknown(id) : v;
    }
    case Opcode::flag:
      return environment_->flags[n.a] != 0 ? kTrue : kFalse;
    case Opcode::event:
      return event(n.a, id);
    case Opcode::event_present:
      return event_present(n.a, id);
    case Opcode::event_latest:
      return latest(n.a, id);
    case Opcode::response:
      return response(n.a, {}, n.b != 0, false, id);
    case Opcode::response_present:
      return response(n.a, {}, n.b != 0, true, id);
    case Opcode::dynamic_event:
      return dynamic_event(n, id);
    case Opcode::dynamic_response:
      return dynamic_response(n, id);
    case Opcode::collection:
      return collection(n, id, out);
    case Opcode::field:
      return field(n, id, out);
    case Opcode::index:
      return index(n, id, out);
    case Opcode::slice:
      return slice(n, id, out);
    case Opcode::negative:
    case Opcode::positive:
      return unary(n, id, out);
    case Opcode::add:
    case Opcode::subtract:
    case Opcode::multiply:
    case Opcode::divide:
    case Opcode::floor_divide:
    case Opcode::modulo:
    case Opcode::power:
      return binary(n, id, out);
    case Opcode::less:
    case Opcode::less_equal:
    case Opcode::greater:
    case Opcode::greater_equal:
    case Opcode::equal:
    case Opcode::not_equal:
    case Opcode::in:
    case Opcode::not_in:
    case Opcode::is_none:
    case Opcode::is_not_none:
      return from_truth(compare_node(n, id));
    case Opcode::chain:
      return from_truth(chain(n, id));
    case Opcode::logical_not: {
      const Truth t = test(n.a);
      return t == Truth::unknown || t == Truth::fault ? kUnknown : t == Truth::yes ? kFalse : kTrue;
    }
    case Opcode::logical_and:
    case Opcode::logical_or:
      return logical(n, out);
    case Opcode::conditional:
      return conditional(n, out);
    case Opcode::list:
      return list(n, id, out);
    case Opcode::dict:
      return dict(n, id, out);
    case Opcode::comprehension:
      return comprehension(n, id, out);
    case Opcode::fstring:
      return fstring(n, id, out);
    case Opcode::format:
      return format(n, id, out);
    case Opcode::available:
      return available(n, out);
    case Opcode::function:
      return function_call(n, id, out);
    case Opcode::method:
    case Opcode::mutate_temporary:
      return method_call(n, id, out);
    case Opcode::mutate:
      return mutate(n, id, out);
    case Opcode::invalid_call:
      return invalid_call(n, id);
    case Opcode::copy: {
      const Value& v = evaluate(n.a, out);
      if (&v != &out) out = v;
      return v.is_unknown() ? kUnknown : out;
    }
    default:
      return kUnknown;  // statements are executed, not evaluated
  }
}

// Arithmetic.

const Value& Machine::binary(const Node& n, NodeId id, Value& out) {
  Value left_out;
  Value right_out;
  const Value& l = operand(n.a, left_out);
  if (l.is_unknown() && stopped_) return kUnknown;
  const Value& r = operand(n.b, right_out);
  if (l.is_unknown() || r.is_unknown()) return kUnknown;
  // OPTIMIZATION: + - * of two numbers of one kind.
  if (n.op <= Opcode::multiply && l.is_integer() && r.is_integer()) {
    const std::int64_t a = l.as_integer();
    const std::int64_t b = r.as_integer();
    std::int64_t result = 0;
    const bool overflow = n.op == Opcode::add        ? __builtin_add_overflow(a, b, &result)
                          : n.op == Opcode::subtract ? __builtin_sub_overflow(a, b, &result)
                                                     : __builtin_mul_overflow(a, b, &result);
    if (!overflow) {
      out = Value(result);
      return out;
    }
  } else if (n.op <= Opcode::multiply && l.is_number() && r.is_number()) {
    const double a = l.as_number();
    const double b = r.as_number();
    out = Value(n.op == Opcode::add ? a + b : n.op == Opcode::subtract ? a - b : a * b);
    return out;
  }
  return checked(arithmetic(context_, binary_operator(n.op), l, r), id, out);
}

const Value& Machine::unary(const Node& n, NodeId id, Value& out) {
  Value operand_out;
  const Value& v = operand(n.a, operand_out);
  if (v.is_unknown()) return kUnknown;
  return checked(sign(context_, unary_operator(n.op), v), id, out);
}

}  // namespace race::language
