#include "core/language/interface/fault.h"

#include <array>

namespace race::language {

std::string_view name(FaultKind kind) {
  static constexpr std::array<std::string_view, 10> kNames = {
      "type", "missing", "zero_division", "overflow", "budget", "value", "name", "unmet", "unresolved", "divergence"};
  static_assert(kNames.size() == static_cast<std::size_t>(FaultKind::divergence) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace race::language
