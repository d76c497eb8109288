// Comparisons and arithmetic, as Python's.
#include <cmath>

#include "core/language/primitives/numbers.h"
#include "core/language/primitives/search.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language {
namespace {

std::string_view symbol(BinaryOperator op) {
  switch (op) {
    case BinaryOperator::add:
      return "+";
    case BinaryOperator::subtract:
      return "-";
    case BinaryOperator::multiply:
      return "*";
    case BinaryOperator::divide:
      return "/";
    case BinaryOperator::floor_divide:
      return "//";
    case BinaryOperator::modulo:
      return "%";
    case BinaryOperator::power:
      return "** or pow()";
    case BinaryOperator::less:
      return "<";
    case BinaryOperator::less_equal:
      return "<=";
    case BinaryOperator::greater:
      return ">";
    default:
      return ">=";
  }
}

bool is_real(const Value& v) { return v.is_numeric() || v.is_bool(); }
bool is_whole(const Value& v) { return v.is_integer() || v.is_bool(); }
double real(const Value& v) { return v.is_number() ? v.as_number() : static_cast<double>(v.as_integer()); }

enum class Order : std::uint8_t { less, equal, greater, none };  // none: NaN

template <typename T>
Order order(const T& a, const T& b) {
  return a < b ? Order::less : a > b ? Order::greater : a == b ? Order::equal : Order::none;
}

Order order_of_reals(const Value& a, const Value& b) {
  if (is_whole(a) && is_whole(b)) return order(a.as_integer(), b.as_integer());
  if (a.is_number() && b.is_number()) return order(a.as_number(), b.as_number());
  const double d = a.is_number() ? a.as_number() : b.as_number();
  if (std::isnan(d)) return Order::none;
  if (a.is_number()) return order(0, compare(b.as_integer(), d));
  return order(compare(a.as_integer(), d), 0);
}

Order order_of(Context& context, BinaryOperator op, const Value& a, const Value& b) {
  if (is_real(a) && is_real(b)) return order_of_reals(a, b);
  if (a.is_string() && b.is_string()) {
    if (!context.charge(1 + work::block(std::min(a.as_string().size(), b.as_string().size())))) return Order::none;
    return order(a.as_string(), b.as_string());  // UTF-8 keeps the order of code points
  }
  if (a.is_list() && b.is_list()) {
    const List& x = a.as_list();
    const List& y = b.as_list();
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i)
      if (!context.charge_element(i) || !equal(context, x[i], y[i]))
        return context.failed ? Order::none : order_of(context, op, x[i], y[i]);
    return order(x.size(), y.size());
  }
  context.fail(FaultKind::type, "'" + std::string(symbol(op)) + "' not supported between instances of '" +
                                    std::string(type_name(a)) + "' and '" + std::string(type_name(b)) + "'");
  return Order::none;
}

bool contains(Context& context, const Value& container, const Value& item) {
  if (container.is_list()) {
    const List& items = container.as_list();
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (!context.charge_element(i)) return false;
      if (equal(context, items[i], item)) return true;
    }
    return false;
  }
  if (container.is_dict()) {
    if (item.is_list() || item.is_dict())
      context.fail(FaultKind::type, "unhashable type: '" + std::string(type_name(item)) + "'");
    return item.is_string() && context.charge(work::block(item.as_string().size())) &&
           container.as_dict().find(item) != nullptr;
  }
  if (container.is_string()) {
    if (item.is_string())
      return context.charge(work::search(container.as_string().size() + item.as_string().size())) &&
             find_first(container.as_string(), item.as_string()) != kNowhere;
    context.fail(FaultKind::type, "'in <string>' requires string as left operand, not " + std::string(type_name(item)));
    return false;
  }
  context.fail(FaultKind::type, "argument of type '" + std::string(type_name(container)) + "' is not iterable");
  return false;
}

Value overflow(Context& context) { return context.fail(FaultKind::overflow, "integer out of 64 bits"); }

Value of_integers(Context& context, BinaryOperator op, std::int64_t a, std::int64_t b) {
  std::int64_t result = 0;
  switch (op) {
    case BinaryOperator::add:
      return __builtin_add_overflow(a, b, &result) ? overflow(context) : Value(result);
    case BinaryOperator::subtract:
      return __builtin_sub_overflow(a, b, &result) ? overflow(context) : Value(result);
    case BinaryOperator::multiply:
      return __builtin_mul_overflow(a, b, &result) ? overflow(context) : Value(result);
    case BinaryOperator::divide:
      if (b == 0) return context.fail(FaultKind::zero_division, "division by zero");
      return Value(true_divide(a, b));
    case BinaryOperator::floor_divide:
    case BinaryOperator::modulo:
      if (b == 0) return context.fail(FaultKind::zero_division, "integer division or modulo by zero");
      if (b == -1) return op == BinaryOperator::modulo ? Value(0) : a == INT64_MIN ? overflow(context) : Value(-a);
      return Value(op == BinaryOperator::modulo ? floor_modulo(a, b) : floor_divide(a, b));
    default:
      if (b >= 0) {
        const auto power_of = power(a, b);
        return power_of ? Value(*power_of) : overflow(context);
      }
      if (a == 0) return context.fail(FaultKind::zero_division, "0.0 cannot be raised to a negative power");
      return Value(std::pow(static_cast<double>(a), static_cast<double>(b)));
  }
}

Value power_of_reals(Context& context, double a, double b) {
  if (a == 0 && b < 0) return context.fail(FaultKind::zero_division, "0.0 cannot be raised to a negative power");
  if (a < 0 && std::isfinite(a) && std::isfinite(b) && b != std::floor(b))
    return context.fail(FaultKind::value, "a negative number to a fractional power is complex");
  const double result = std::pow(a, b);
  if (std::isinf(result) && std::isfinite(a) && std::isfinite(b))
    return context.fail(FaultKind::overflow, "numerical result out of range");
  return Value(result);
}

Value of_reals(Context& context, BinaryOperator op, double a, double b) {
  switch (op) {
    case BinaryOperator::add:
      return Value(a + b);
    case BinaryOperator::subtract:
      return Value(a - b);
    case BinaryOperator::multiply:
      return Value(a * b);
    case BinaryOperator::divide:
      if (b == 0) return context.fail(FaultKind::zero_division, "float division by zero");
      return Value(a / b);
    case BinaryOperator::floor_divide:
      if (b == 0) return context.fail(FaultKind::zero_division, "float floor division by zero");
      return Value(floor_divide(a, b));
    case BinaryOperator::modulo:
      if (b == 0) return context.fail(FaultKind::zero_division, "float modulo");
      return Value(floor_modulo(a, b));
    default:
      return power_of_reals(context, a, b);
  }
}

// sequence * count
Value repeated(Context& context, const Value& sequence, std::int64_t count) {
  const auto times = static_cast<std::uint64_t>(std::max<std::int64_t>(count, 0));
  const std::uint64_t units = sequence.is_string() ? sequence.as_string().size() : sequence.as_list().size();
  if (units == 0 || times == 0) return sequence.is_string() ? Value("") : Value(List());
  if (times > context.value_units || !check_units(context, units * times)) {
    check_units(context, context.value_units);
    return Value::unknown();
  }
  if (!context.charge(work::elements(times) +
                      (sequence.is_string() ? work::block(units * times) : work::elements(units * times))))
    return Value::unknown();
  if (sequence.is_string()) {
    std::string text;
    text.reserve(units * times);
    for (std::uint64_t i = 0; i < times; ++i) text += sequence.as_string();
    return Value(std::move(text));
  }
  List items;
  items.reserve(units * times);
  for (std::uint64_t i = 0; i < times; ++i)
    items.insert(items.end(), sequence.as_list().begin(), sequence.as_list().end());
  return within_limits(context, Value(std::move(items)));
}

Value joined(Context& context, const Value& a, const Value& b) {
  if (a.is_string()) {
    const std::size_t size = a.as_string().size() + b.as_string().size();
    if (!check_units(context, size) || !context.charge(work::block(size))) return Value::unknown();
    return Value(a.as_string() + b.as_string());
  }
  if (!context.charge(work::elements(a.as_list().size() + b.as_list().size()))) return Value::unknown();
  List items = a.as_list();
  items.insert(items.end(), b.as_list().begin(), b.as_list().end());
  return within_limits(context, Value(std::move(items)));
}

}  // namespace

bool compare(Context& context, BinaryOperator op, const Value& a, const Value& b) {
  switch (op) {
    case BinaryOperator::equal:
      return equal(context, a, b);
    case BinaryOperator::not_equal:
      return !equal(context, a, b);
    case BinaryOperator::in:
      return contains(context, b, a);
    case BinaryOperator::not_in:
      return !contains(context, b, a);
    case BinaryOperator::is_none:
      return a.is_null();
    case BinaryOperator::is_not_none:
      return !a.is_null();
    default:
      break;
  }
  const Order found = order_of(context, op, a, b);
  if (found == Order::none) return false;
  if (found == Order::equal) return op == BinaryOperator::less_equal || op == BinaryOperator::greater_equal;
  return found == Order::less ? op == BinaryOperator::less || op == BinaryOperator::less_equal
                              : op == BinaryOperator::greater || op == BinaryOperator::greater_equal;
}

Value arithmetic(Context& context, BinaryOperator op, const Value& a, const Value& b) {
  if (is_whole(a) && is_whole(b)) return of_integers(context, op, a.as_integer(), b.as_integer());
  if (is_real(a) && is_real(b)) return of_reals(context, op, real(a), real(b));
  const auto sequence = [](const Value& v) { return v.is_string() || v.is_list(); };
  if (op == BinaryOperator::add && sequence(a) && a.kind() == b.kind()) return joined(context, a, b);
  if (op == BinaryOperator::multiply && sequence(a) && is_whole(b)) return repeated(context, a, b.as_integer());
  if (op == BinaryOperator::multiply && sequence(b) && is_whole(a)) return repeated(context, b, a.as_integer());
  return context.fail(FaultKind::type, "unsupported operand type(s) for " + std::string(symbol(op)) + ": '" +
                                           std::string(type_name(a)) + "' and '" + std::string(type_name(b)) + "'");
}

Value sign(Context& context, UnaryOperator op, const Value& a) {
  if (a.is_number()) return Value(op == UnaryOperator::negative ? -a.as_number() : a.as_number());
  if (!is_whole(a))
    return context.fail(FaultKind::type, "bad operand type for unary " +
                                             std::string(op == UnaryOperator::negative ? "-" : "+") + ": '" +
                                             std::string(type_name(a)) + "'");
  if (op == UnaryOperator::positive) return Value(a.as_integer());
  return a.as_integer() == INT64_MIN ? overflow(context) : Value(-a.as_integer());
}

}  // namespace race::language
