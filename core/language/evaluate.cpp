// Evaluation: entry points, references and operators.
#include <cmath>

#include "core/language/machine_internal.h"

namespace race::language {

const Value Machine::kUnknown = Value::unknown();
const Value Machine::kTrue = Value(true);
const Value Machine::kFalse = Value(false);

void Machine::begin(const Program& program, Environment& environment, bool strict) {
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
bool Machine::over() {
  if (left_ < 0 && !stopped_)
    fail(FaultKind::budget, "more than " + std::to_string(limits_.steps) + " steps", program_->root);
  return stopped_;
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
    if (!stopped_) fail(FaultKind::budget, "more than " + std::to_string(limits_.steps) + " steps", id);
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
      return response(n.a, n.b != 0, false, id);
    case Op::response_present:
      return response(n.a, n.b != 0, true, id);
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

// Truth.

Truth Machine::truth_of(const Value& v) const {
  if (v.is_unknown()) return stopped_ ? Truth::fault : Truth::unknown;
  return truth(v) ? Truth::yes : Truth::no;
}

const Value& Machine::from_truth(Truth truth) {
  return truth == Truth::yes ? kTrue : truth == Truth::no ? kFalse : kUnknown;
}

// The truth of a part in a boolean position.
Truth Machine::test(NodeId id) {
  const Node& n = nodes_[id];
  switch (n.op) {
    case Op::less:
    case Op::less_equal:
    case Op::greater:
    case Op::greater_equal:
    case Op::equal:
    case Op::not_equal:
      --left_;
      return compare_node(n, id);
    case Op::logical_and:
      --left_;
      return all_of(n);
    case Op::logical_or:
      --left_;
      return any_of(n);
    case Op::logical_not: {
      --left_;
      const Truth t = test(n.a);
      return t == Truth::yes ? Truth::no : t == Truth::no ? Truth::yes : t;
    }
    case Op::flag:
      --left_;
      return environment_->flags[n.a] != 0 ? Truth::yes : Truth::no;
    default: {
      Value out;
      return truth_of(evaluate(id, out));
    }
  }
}

// Kleene's and: no if one is no, else unknown if one is unknown. Those behind a no are not evaluated.
Truth Machine::all_of(const Node& n) {
  const std::uint32_t* parts = program_->run(n);
  Truth result = Truth::yes;
  for (std::size_t i = 0; i < n.count; ++i) {
    const Truth t = test(parts[i]);
    if (t == Truth::no || t == Truth::fault) return t;
    if (t == Truth::unknown) result = t;
    if (stopped_) return Truth::fault;
  }
  return result;
}

Truth Machine::any_of(const Node& n) {
  const std::uint32_t* parts = program_->run(n);
  Truth result = Truth::no;
  for (std::size_t i = 0; i < n.count; ++i) {
    const Truth t = test(parts[i]);
    if (t == Truth::yes || t == Truth::fault) return t;
    if (t == Truth::unknown) result = t;
    if (stopped_) return Truth::fault;
  }
  return result;
}

// As test(), telling the trace each atom: each maximal part without and, or, not.
Truth Machine::traced(NodeId id) {
  const Node& n = nodes_[id];
  if (n.op == Op::logical_not) {
    --left_;
    const Truth t = traced(n.a);
    return t == Truth::yes ? Truth::no : t == Truth::no ? Truth::yes : t;
  }
  if (n.op != Op::logical_and && n.op != Op::logical_or) {
    const Truth t = test(id);
    if (t != Truth::fault) environment_->trace->atom(n.service, t, program_->range(id));
    return t;
  }
  --left_;
  const Truth decides = n.op == Op::logical_and ? Truth::no : Truth::yes;
  Truth result = decides == Truth::no ? Truth::yes : Truth::no;
  const std::uint32_t* parts = program_->run(n);
  for (std::size_t i = 0; i < n.count; ++i) {
    const Truth t = traced(parts[i]);
    if (t == decides || t == Truth::fault) return t;
    if (t == Truth::unknown) result = t;
  }
  return result;
}

// and, or as values: the operand that decides. An unknown operand before it leaves only its truth.
const Value& Machine::logical(const Node& n, Value& out) {
  const bool decides = n.op == Op::logical_or;
  const std::uint32_t* parts = program_->run(n);
  bool any_unknown = false;
  for (std::size_t i = 0; i < n.count; ++i) {
    const Value& v = evaluate(parts[i], out);
    if (stopped_) return kUnknown;
    const Truth t = truth_of(v);
    if (t == Truth::unknown) {
      any_unknown = true;
    } else if ((t == Truth::yes) == decides) {
      return any_unknown ? (decides ? kTrue : kFalse) : v;
    } else if (i + 1 == n.count) {
      return any_unknown ? kUnknown : v;
    }
  }
  return kUnknown;
}

const Value& Machine::conditional(const Node& n, Value& out) {
  const Truth t = test(n.a);
  if (t == Truth::unknown || t == Truth::fault) return kUnknown;
  return evaluate(t == Truth::yes ? n.b : n.c, out);
}

// Comparisons.

Truth Machine::compare_node(const Node& n, NodeId id) {
  Value left_out;
  Value right_out;
  const Value& l = operand(n.a, left_out);
  if (l.is_unknown() && stopped_) return Truth::fault;
  const Value& r = operand(n.b, right_out);
  if (l.is_unknown() || r.is_unknown()) return stopped_ ? Truth::fault : Truth::unknown;
  // OPTIMIZATION: two numbers of one kind need no look at the others.
  const auto decide = [&](auto a, auto b) {
    switch (n.op) {
      case Op::less:
        return a < b;
      case Op::less_equal:
        return a <= b;
      case Op::greater:
        return a > b;
      case Op::greater_equal:
        return a >= b;
      case Op::equal:
        return a == b;
      default:
        return a != b;
    }
  };
  bool result = false;
  if (n.op <= Op::not_equal && l.is_integer() && r.is_integer()) {
    result = decide(l.as_integer(), r.as_integer());
  } else if (n.op <= Op::not_equal && l.is_number() && r.is_number()) {
    result = decide(l.as_number(), r.as_number());
  } else {
    result = compare(context_, n.op, l, r);
    if (context_.failed) return located(id), Truth::fault;
  }
  return result ? Truth::yes : Truth::no;
}

// a < b < c is `a < b and b < c` with b evaluated once: Kleene's and of its parts.
Truth Machine::chain(const Node& n, NodeId id) {
  const std::uint32_t* run = program_->run(n);
  Value left_out;
  Value right_out;
  Truth result = Truth::yes;
  Value l = evaluate(run[0], left_out);
  for (std::size_t i = 1; i + 1 < n.count && !stopped_; i += 2) {
    const Value& r = evaluate(run[i + 1], right_out);
    if (stopped_) break;
    if (l.is_unknown() || r.is_unknown()) {
      result = Truth::unknown;
    } else {
      const bool holds = compare(context_, static_cast<Op>(run[i]), l, r);
      if (context_.failed) return located(id), Truth::fault;
      if (!holds) return Truth::no;
    }
    l = r;
  }
  return stopped_ ? Truth::fault : result;
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
