#include "core/execution/order_choice.h"

#include <charconv>

namespace race::execution {

using semantics::Order;

Expected<OrderChoice> read_order(std::string_view text) {
  if (text == "declared") return OrderChoice{};
  if (text == "reversed") return OrderChoice{.kind = OrderChoice::Kind::reversed};
  OrderChoice choice{.kind = OrderChoice::Kind::random};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), choice.seed);
  if (error != std::errc() || end != text.data() + text.size() || text.empty())
    return unexpected(ErrorCode::type, "an order is `declared`, `reversed` or a seed, a number from 0");
  return choice;
}

Order make_order(const semantics::Program& program, OrderChoice choice) {
  if (choice.kind == OrderChoice::Kind::reversed) return Order::reversed(program);
  if (choice.kind == OrderChoice::Kind::random) return Order::random(program, choice.seed);
  return Order::declared();
}

}  // namespace race::execution
