// Faults: why an evaluation cannot go on (SEMANTICS.md section 2, R4).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/value/expected.h"

namespace race::language {

enum class FaultKind : std::uint8_t {
  type,
  missing,
  zero_division,
  overflow,
  budget,
  value,
  name,
  unmet,
  unresolved,
  divergence
};
std::string_view name(FaultKind kind);

struct Fault {
  FaultKind kind = FaultKind::type;
  std::string message;
  SourceRange where;
};

}  // namespace race::language
