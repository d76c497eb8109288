#include "core/language/compile/condition_analysis_internal.h"
#include "core/language/values/values.h"

namespace race::language {

Comparison comparison_of(const Program& condition) {
  const Node& root = condition.nodes[condition.root];
  if (root.op < Opcode::less || root.op > Opcode::not_equal) return {};
  const Node& bound = condition.nodes[root.b];
  if (bound.op != Opcode::constant || !condition.constants[bound.a].is_numeric()) return {};
  Comparison made{.op = root.op, .bound = bound.a};
  const Node* datum = &condition.nodes[root.a];
  if (datum->op == Opcode::field) {
    made.key = datum->b;
    datum = &condition.nodes[datum->a];
  }
  if (datum->op != Opcode::event && datum->op != Opcode::event_latest && datum->op != Opcode::slot) return {};
  made.datum = datum->op;
  made.number = datum->a;
  return made;
}

namespace {

// What is certain about a part of a condition if no event occurs. Unknown is neither true nor false.
struct Certain {
  bool not_true = false, not_false = false;
  bool no_fault = false;
  bool unknown() const { return not_true && not_false && no_fault; }
};
constexpr Certain kNothing = {false, false, false};
constexpr Certain kSomeValue = {false, false, true};
constexpr Certain kAlwaysUnknown = {true, true, true};

class OccurrenceAnalysis {
 public:
  OccurrenceAnalysis(const Program& condition, const ServiceTable& services)
      : program_(condition), services_(services) {}

  Certain part(NodeId id) const {
    const Node& n = program_.nodes[id];
    switch (n.op) {
      case Opcode::constant: {
        const bool yes = truth(program_.constants[n.a]);
        return {!yes, yes, true};
      }
      case Opcode::slot:
      case Opcode::flag:
      case Opcode::event_latest:
      case Opcode::response:
      case Opcode::response_present:
        return kSomeValue;
      case Opcode::event_present:
        return kAlwaysUnknown;
      case Opcode::event:
        return services_.events()[n.a].sampled ? kSomeValue : kAlwaysUnknown;
      case Opcode::field:  // of something known it may be missing
        return part(n.a).unknown() ? kAlwaysUnknown : kNothing;
      case Opcode::less:
      case Opcode::less_equal:
      case Opcode::greater:
      case Opcode::greater_equal:
      case Opcode::equal:
      case Opcode::not_equal:
        return comparison(part(n.a), part(n.b));
      case Opcode::logical_not: {
        const Certain c = part(n.a);
        return {c.not_false, c.not_true, c.no_fault};
      }
      case Opcode::logical_and:
      case Opcode::logical_or:
        return logical(n);
      default:
        return kNothing;
    }
  }

 private:
  // Operands of both sides are evaluated; one that is unknown makes the comparison unknown.
  static Certain comparison(Certain left, Certain right) {
    return left.no_fault && right.no_fault && (left.unknown() || right.unknown()) ? kAlwaysUnknown : kNothing;
  }

  // Kleene: `and` is not true if one part is not, and not false if no part is; `or` the other way round.
  Certain logical(const Node& n) const {
    Certain some = {false, false, true};
    Certain all = {true, true, true};
    for (std::size_t i = 0; i < n.count; ++i) {
      const Certain c = part(program_.run(n)[i]);
      some.not_true |= c.not_true;
      some.not_false |= c.not_false;
      all.not_true &= c.not_true;
      all.not_false &= c.not_false;
      all.no_fault &= c.no_fault;
    }
    if (n.op == Opcode::logical_and) return {some.not_true, all.not_false, all.no_fault};
    return {all.not_true, some.not_false, all.no_fault};
  }

  const Program& program_;
  const ServiceTable& services_;
};

}  // namespace

bool needs_occurrence(const Program& condition, const ServiceTable& services) {
  if (condition.nodes.size() > kSmallBudget) return false;
  const Certain whole = OccurrenceAnalysis(condition, services).part(condition.root);
  return whole.not_true && whole.no_fault;
}

}  // namespace race::language
