// The operators of the language.
#pragma once

#include <cstdint>

namespace race::language {

enum class UnaryOperator : std::uint8_t { negative, positive, logical_not };

enum class BinaryOperator : std::uint8_t {
  add,
  subtract,
  multiply,
  divide,
  floor_divide,
  modulo,
  power,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  in,
  not_in,
  is_none,
  is_not_none,
  logical_and,
  logical_or,
};

}  // namespace race::language
