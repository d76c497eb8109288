// Evaluation of conditions: Kleene's three-valued logic (R2) and comparisons.
#include "core/language/evaluate/comparison_internal.h"
#include "core/language/evaluate/machine_internal.h"

namespace race::language {

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
    case Opcode::less:
    case Opcode::less_equal:
    case Opcode::greater:
    case Opcode::greater_equal:
    case Opcode::equal:
    case Opcode::not_equal:
      --context_.left;
      if (is_told_to_stop()) return context_.left = -1, Truth::unknown;  // the end of the evaluation sees it
      return compare_node(n, id);
    case Opcode::logical_and:
      --context_.left;
      return all_of(n);
    case Opcode::logical_or:
      --context_.left;
      return any_of(n);
    case Opcode::logical_not: {
      --context_.left;
      const Truth t = test(n.a);
      return t == Truth::yes ? Truth::no : t == Truth::no ? Truth::yes : t;
    }
    case Opcode::flag:
      --context_.left;
      return environment_->flags[n.a] != 0 ? Truth::yes : Truth::no;
    default: {
      Value out;
      return truth_of(evaluate(id, out));
    }
  }
}

// Kleene's and: no if one is no, else unknown if one is unknown. Parts after a no are not evaluated.
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

// As test(); records each atom in the trace: each maximal part without and, or, not.
Truth Machine::test_traced(NodeId id) {
  const Node& n = nodes_[id];
  if (n.op == Opcode::logical_not) {
    --context_.left;
    const Truth t = test_traced(n.a);
    return t == Truth::yes ? Truth::no : t == Truth::no ? Truth::yes : t;
  }
  if (n.op != Opcode::logical_and && n.op != Opcode::logical_or) {
    const Truth t = test(id);
    if (t != Truth::fault) environment_->trace->atom(n.service, t, program_->range(id));
    return t;
  }
  --context_.left;
  const Truth decides = n.op == Opcode::logical_and ? Truth::no : Truth::yes;
  Truth result = decides == Truth::no ? Truth::yes : Truth::no;
  const std::uint32_t* parts = program_->run(n);
  for (std::size_t i = 0; i < n.count; ++i) {
    const Truth t = test_traced(parts[i]);
    if (t == decides || t == Truth::fault) return t;
    if (t == Truth::unknown) result = t;
  }
  return result;
}

// and, or as values: the operand that decides. After an unknown operand only its truth is known.
const Value& Machine::logical(const Node& n, Value& out) {
  const bool decides = n.op == Opcode::logical_or;
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
  // OPTIMIZATION: two numbers of one kind are compared here.
  const auto decide = [&](auto a, auto b) { return holds(n.op, a, b); };
  bool result = false;
  if (n.op <= Opcode::not_equal && l.is_integer() && r.is_integer()) {
    result = decide(l.as_integer(), r.as_integer());
  } else if (n.op <= Opcode::not_equal && l.is_number() && r.is_number()) {
    result = decide(l.as_number(), r.as_number());
  } else {
    result = compare(context_, binary_operator(n.op), l, r);
    if (context_.failed) return locate_fault(id), Truth::fault;
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
      const bool holds = compare(context_, static_cast<BinaryOperator>(run[i]), l, r);
      if (context_.failed) return locate_fault(id), Truth::fault;
      if (!holds) return Truth::no;
    }
    l = r;
  }
  return stopped_ ? Truth::fault : result;
}

}  // namespace race::language
