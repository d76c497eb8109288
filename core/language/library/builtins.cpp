// Builtin functions about numbers, and print.
#include <cmath>

#include "core/language/library/library_internal.h"
#include "core/language/primitives/numbers.h"
#include "core/language/values/printing.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {
namespace {

// The least or greatest by <; the first of equals.
Value extreme(Context& context, Arguments arguments, BinaryOperator better, std::string_view name) {
  Value items;
  if (arguments.size() == 2) {
    items = elements(context, arguments[1]);
    if (context.failed) return items;
  } else {
    if (!context.charge(work::elements(arguments.size()))) return Value::unknown();
    items = Value(List(arguments.begin() + 1, arguments.end()));
    if (items.as_list().empty())
      return context.fail(FaultKind::type, std::string(name) + " expected at least 1 argument, got 0");
    if (given(arguments, 0))
      return context.fail(FaultKind::type, "Cannot specify a default with multiple positional arguments");
  }
  const List& list = items.as_list();
  if (list.empty()) {
    if (given(arguments, 0)) return arguments[0];
    return context.fail(FaultKind::value, std::string(name) + "() arg is an empty sequence");
  }
  const Value* best = &list[0];
  if (!context.charge(work::elements(list.size()))) return Value::unknown();
  for (const Value& item : list) {
    if (&item != best && compare(context, better, item, *best)) best = &item;
    if (context.failed) return Value::unknown();
  }
  return *best;
}

// n to tens, hundreds, ...: half to even
Value rounded(Context& context, std::int64_t n, std::int64_t digits) {
  if (digits >= 0) return Value(n);
  if (digits < -19) return Value(0);
  __extension__ using Wide = __int128;
  Wide unit = 1;
  for (std::int64_t i = digits; i < 0; ++i) unit *= 10;
  Wide quotient = n / unit;
  const Wide rest = n - quotient * unit;
  const Wide twice = (rest < 0 ? -rest : rest) * 2;
  if (twice > unit || (twice == unit && quotient % 2 != 0)) quotient += n < 0 ? -1 : 1;
  const Wide result = quotient * unit;
  if (result > INT64_MAX || result < INT64_MIN) return context.fail(FaultKind::overflow, "integer out of 64 bits");
  return Value(static_cast<std::int64_t>(result));
}

}  // namespace

Value absolute(Context& context, Arguments arguments) {
  const Value& v = arguments[0];
  if (v.is_number()) return Value(std::fabs(v.as_number()));
  if (!v.is_integer() && !v.is_bool())
    return context.fail(FaultKind::type, "bad operand type for abs(): '" + std::string(type_name(v)) + "'");
  return v.as_integer() < 0 ? sign(context, UnaryOperator::negative, v) : Value(v.as_integer());
}

Value maximum(Context& context, Arguments arguments) {
  return extreme(context, arguments, BinaryOperator::greater, "max");
}
Value minimum(Context& context, Arguments arguments) {
  return extreme(context, arguments, BinaryOperator::less, "min");
}

Value sum(Context& context, Arguments arguments) {
  const Value items = elements(context, arguments[0]);
  if (context.failed) return items;
  Value total = given(arguments, 1) ? arguments[1] : Value(0);
  if (total.is_string()) return context.fail(FaultKind::type, "sum() can't sum strings [use ''.join(seq) instead]");
  if (!context.charge(work::elements(items.as_list().size()))) return Value::unknown();
  for (const Value& item : items.as_list()) {
    total = arithmetic(context, BinaryOperator::add, total, item);
    if (context.failed) return Value::unknown();
  }
  return total;
}

Value round_number(Context& context, Arguments arguments) {
  const Value& v = arguments[0];
  if (!v.is_numeric() && !v.is_bool())
    return context.fail(FaultKind::type, "type " + std::string(type_name(v)) + " doesn't define __round__ method");
  const bool whole = !given(arguments, 1) || arguments[1].is_null();
  std::int64_t digits = 0;
  if (!whole) {
    const auto n = integer(context, arguments[1]);
    if (!n) return Value::unknown();
    digits = *n;
  }
  if (!v.is_number()) return rounded(context, v.as_integer(), digits);
  const double d = v.as_number();
  if (!whole) {
    if (!std::isfinite(d) || digits > 400) return v;
    const double result = round_decimal(d, static_cast<int>(std::max<std::int64_t>(digits, -400)));
    if (std::isinf(result)) return context.fail(FaultKind::overflow, "rounded value too large to represent");
    return Value(result);
  }
  if (std::isnan(d)) return context.fail(FaultKind::value, "cannot convert float NaN to integer");
  const double nearest = std::nearbyint(d);
  if (std::isinf(d) || nearest >= 9223372036854775808.0 || nearest < -9223372036854775808.0)
    return context.fail(FaultKind::overflow, "integer out of 64 bits");
  return Value(static_cast<std::int64_t>(nearest));
}

Value print(Context& context, Arguments arguments) {
  std::string parts[2] = {" ", "\n"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!given(arguments, i) || arguments[i].is_null()) continue;
    if (!arguments[i].is_string()) return context.fail(FaultKind::type, "sep and end must be None or a string");
    parts[i] = arguments[i].as_string();
  }
  std::string text;
  for (std::size_t i = 2; i < arguments.size(); ++i) {
    if (!charge_printing(context, arguments[i]) || !context.charge(work::block(parts[0].size())))
      return Value::unknown();
    if (i > 2) text += parts[0];
    text += str(arguments[i]);
    if (!check_units(context, text.size())) return Value::unknown();
  }
  if (!context.charge(work::made(1) + work::block(parts[1].size()))) return Value::unknown();
  context.environment->print(text + parts[1]);
  return {};
}

}  // namespace race::language::library
