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
  left_ = static_cast<std::int64_t>(limits_.steps);
  strict_ = strict;
  stopped_ = false;
  context_.failed = false;
  context_.environment = &environment;
  if (!program.locals.empty()) locals_.assign(program.locals.size(), Value::unknown());
}

// OPTIMIZATION: reading a leaf takes a unit of the budget without looking; so an evaluation looks again at its end.
inline bool Machine::over() {
  if (left_ < 0) exhausted(program_->root);
  return stopped_;
}

void Machine::exhausted(NodeId id) {
  if (!stopped_) fail(FaultKind::budget, "more than " + std::to_string(limits_.steps) + " steps", id);
}

Truth Machine::condition(const Program& program, Environment& environment) {
  begin(program, environment, false);
  const Truth truth = environment.trace == nullptr ? test(program.root) : traced(program.root);
  return over() ? Truth::fault : truth;
}

Truth Machine::part(const Program& program, Environment& environment, NodeId node) {
  begin(program, environment, false);
  const Truth truth = test(node);
  return over() ? Truth::fault : truth;
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
  if (!over() && !result.is_unknown() && !storable(context_, result)) located(program.root);
  if (stopped_) return std::nullopt;
  return result;
}

Interpreter::Outcome Machine::function(const Program& program, Environment& environment) {
  begin(program, environment, true);
  execute(program.root);
  over();
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
  return located(id);
}

const Value& Machine::located(NodeId id) {
  if (!stopped_) context_.fault.where = program_->range(id);
  stopped_ = true;
  return kUnknown;
}

const Value& Machine::kept(Value value, NodeId id, Value& out) {
  if (context_.failed) return located(id);
  out = std::move(value);
  return out;
}

const Value& Machine::evaluate(NodeId id, Value& out) {
  const Node& n = nodes_[id];
  if (--left_ < 0) {
    exhausted(id);
    return kUnknown;
  }
  switch (n.op) {
    case Op::constant:
      return constants_[n.a];
    case Op::local:
      return read_local(n, id);
    case Op::slot: {
      const Value& v = environment_->values[n.a];
      return v.is_unknown() ? unknown(id) : v;
    }
    case Op::flag:
      return environment_->flags[n.a] != 0 ? kTrue : kFalse;
    case Op::event:
      return event(n.a, id);
    case Op::event_present:
      return event_present(n.a, id);
    case Op::event_latest:
      return latest(n.a, id);
    case Op::response:
      return response(n.a, {}, n.b != 0, false, id);
    case Op::response_present:
      return response(n.a, {}, n.b != 0, true, id);
    case Op::dynamic_event:
      return dynamic_event(n, id);
    case Op::dynamic_response:
      return dynamic_response(n, id);
    case Op::collection:
      return collection(n, out);
    case Op::field:
      return field(n, id, out);
    case Op::index:
      return index(n, id, out);
    case Op::slice:
      return slice(n, id, out);
    case Op::negative:
    case Op::positive:
      return unary(n, id, out);
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::floor_divide:
    case Op::modulo:
    case Op::power:
      return binary(n, id, out);
    case Op::less:
    case Op::less_equal:
    case Op::greater:
    case Op::greater_equal:
    case Op::equal:
    case Op::not_equal:
    case Op::in:
    case Op::not_in:
    case Op::is_none:
    case Op::is_not_none:
      return from_truth(compare_node(n, id));
    case Op::chain:
      return from_truth(chain(n, id));
    case Op::logical_not: {
      const Truth t = test(n.a);
      return t == Truth::unknown || t == Truth::fault ? kUnknown : t == Truth::yes ? kFalse : kTrue;
    }
    case Op::logical_and:
    case Op::logical_or:
      return logical(n, out);
    case Op::conditional:
      return conditional(n, out);
    case Op::list:
      return list(n, id, out);
    case Op::dict:
      return dict(n, id, out);
    case Op::comprehension:
      return comprehension(n, id, out);
    case Op::fstring:
      return fstring(n, id, out);
    case Op::format:
      return format(n, id, out);
    case Op::available:
      return available(n, out);
    case Op::function:
      return function_call(n, id, out);
    case Op::method:
    case Op::change_value:
      return method_call(n, id, out);
    case Op::change:
      return change(n, id, out);
    case Op::wrong_call:
      return wrong_call(n, id);
    case Op::hold: {
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
  if (n.op <= Op::multiply && l.is_integer() && r.is_integer()) {
    const std::int64_t a = l.as_integer();
    const std::int64_t b = r.as_integer();
    std::int64_t result = 0;
    const bool overflow = n.op == Op::add        ? __builtin_add_overflow(a, b, &result)
                          : n.op == Op::subtract ? __builtin_sub_overflow(a, b, &result)
                                                 : __builtin_mul_overflow(a, b, &result);
    if (!overflow) {
      out = Value(result);
      return out;
    }
  } else if (n.op <= Op::multiply && l.is_number() && r.is_number()) {
    const double a = l.as_number();
    const double b = r.as_number();
    out = Value(n.op == Op::add ? a + b : n.op == Op::subtract ? a - b : a * b);
    return out;
  }
  return kept(arithmetic(context_, n.op, l, r), id, out);
}

const Value& Machine::unary(const Node& n, NodeId id, Value& out) {
  Value operand_out;
  const Value& v = operand(n.a, operand_out);
  if (v.is_unknown()) return kUnknown;
  return kept(sign(context_, n.op, v), id, out);
}

}  // namespace race::language
