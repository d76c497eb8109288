// A Comparison is decided without the machine. For speed alone: evaluating gives the same.
#pragma once

#include <optional>

#include "core/language/compile/program.h"
#include "core/language/interface/environment.h"

namespace race::language {

template <typename Number>
inline bool holds(Opcode op, Number a, Number b) {
  switch (op) {
    case Opcode::less:
      return a < b;
    case Opcode::less_equal:
      return a <= b;
    case Opcode::greater:
      return a > b;
    case Opcode::greater_equal:
      return a >= b;
    case Opcode::equal:
      return a == b;
    default:
      return a != b;
  }
}

/// OPTIMIZATION: the truth of a Comparison; nothing if an operand is not a number of the kind of the bound.
/// Requires that there is no trace and that the budget allows Comparison::kUnits.
inline std::optional<Truth> decide(const Program& condition, const Environment& environment) {
  const Comparison& c = condition.comparison;
  if (c.datum == Opcode::event && environment.occurrence != c.number && environment.sampled[c.number] == 0)
    return Truth::unknown;
  const Value* found = (c.datum == Opcode::slot ? environment.values : environment.event_data) + c.number;
  if (found->is_unknown()) return Truth::unknown;
  const Value* constants = condition.constants.data();
  if (c.key != kNone) {
    if (!found->is_dict()) return std::nullopt;
    found = found->as_dict().find(constants[c.key]);
    if (found == nullptr) return std::nullopt;
  }
  const Value& bound = constants[c.bound];
  if (found->kind() != bound.kind()) return std::nullopt;
  const bool result = bound.is_integer() ? holds(c.op, found->as_integer(), bound.as_integer())
                                         : holds(c.op, found->as_number(), bound.as_number());
  return result ? Truth::yes : Truth::no;
}

}  // namespace race::language
