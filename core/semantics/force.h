// Force: what a person sets in a running run from outside (core/SEMANTICS.md section 9), as a value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/value/value.h"

namespace race::semantics {

struct Force {
  /// As in the function language: `par`, `res`, `var`; or a port, through which its state is left.
  enum class Scope : std::uint8_t { par, res, var, port } scope = Scope::var;
  std::string path, name;          // of the state; of the value or port
  Value value = Value::unknown();  // of a port: unknown
  bool operator==(const Force&) const = default;
};

std::string_view name(Force::Scope scope);
std::optional<Force::Scope> force_scope(std::string_view name);

}  // namespace race::semantics
