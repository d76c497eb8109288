#include "core/semantics/force.h"

#include <array>

namespace race::semantics {

namespace {
constexpr std::array<std::string_view, 4> kScopes = {"par", "res", "var", "port"};
}

std::string_view name(Force::Scope scope) { return kScopes[static_cast<std::size_t>(scope)]; }

std::optional<Force::Scope> force_scope(std::string_view name) {
  for (std::size_t i = 0; i < kScopes.size(); ++i)
    if (kScopes[i] == name) return static_cast<Force::Scope>(i);
  return std::nullopt;
}

}  // namespace race::semantics
