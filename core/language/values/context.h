// Context: the limits of an evaluation, and where what it calls reports a fault.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/language/interface/environment.h"
#include "core/language/interface/fault.h"
#include "core/value/value.h"

namespace race::language {

/// Where a function says that it failed, and what it must not exceed.
struct Context {
  std::uint64_t value_units = 1'000'000;
  Environment* environment = nullptr;  // for print
  bool failed = false;
  int levels = 0;  // depth of the object of a mutating method in lists and dicts
  Fault fault;

  /// Keeps the first fault; returns unknown, for `return context.fail(...)`.
  Value fail(FaultKind kind, std::string message);
};

/// The arguments in the order of the parameters; one that was not given is unknown. The arguments of `*`
/// follow the named ones.
using Arguments = std::span<const Value>;

}  // namespace race::language
