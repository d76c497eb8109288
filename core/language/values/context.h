// Context: the limits of an evaluation, what is left of its budget, and where what it calls reports a fault.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/language/interface/environment.h"
#include "core/language/interface/fault.h"
#include "core/value/value.h"

namespace race::language {

/// Where a function says what it costs and that it failed, and what it must not exceed.
struct Context {
  std::uint64_t value_units = 1'000'000;
  std::uint64_t steps = 1'000'000;     // the budget of an evaluation, in units of work
  std::int64_t left = 1'000'000;       // of it; below zero the evaluation ends, at its next syntax node at the latest
  Environment* environment = nullptr;  // for print
  bool failed = false;
  int levels = 0;  // depth of the object of a mutating method in lists and dicts
  Fault fault;

  /// Takes `units` of work (values/work.h) off what is left; false and a `budget` fault if that is not enough. To be
  /// called before the work is done, where its size is known.
  bool charge(std::uint64_t units) {
    if (units == 0) return true;
    left -= static_cast<std::int64_t>(units);
    return left >= 0 || fail_over_budget();
  }
  /// As charge(), for one more element of a list that is looked at, the `i`th: of two, one is a unit.
  bool charge_element(std::size_t i) { return i % 2 == 0 || charge(1); }
  /// False: a fault, unless there is one.
  bool fail_over_budget();
  /// Keeps the first fault, with the beginning of a long message; returns unknown, for `return context.fail(...)`.
  Value fail(FaultKind kind, std::string message);
};

/// The arguments in the order of the parameters; one that was not given is unknown. The arguments of `*`
/// follow the named ones.
using Arguments = std::span<const Value>;

}  // namespace race::language
