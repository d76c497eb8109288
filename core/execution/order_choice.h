// Which order of ports, actions and children a run shall have, before its program is known (core/SEMANTICS.md section
// 4).
#pragma once

#include <cstdint>
#include <string_view>

#include "core/semantics/order.h"
#include "core/value/expected.h"

namespace race::execution {

struct OrderChoice {
  enum class Kind : std::uint8_t { declared, reversed, random } kind = Kind::declared;
  std::uint64_t seed = 0;  // of `random`
};

/// "declared", "reversed" or a seed, a number of 64 bits. Error `type`.
Expected<OrderChoice> read_order(std::string_view text);

semantics::Order make_order(const semantics::Program& program, OrderChoice choice);

}  // namespace race::execution
