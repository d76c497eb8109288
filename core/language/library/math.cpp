// The module math: C's functions with Python's faults. What is not defined is a `value` fault, too large `overflow`.
#include <cmath>

#include "core/language/library/library_internal.h"
#include "core/language/values/values.h"

namespace race::language::library {
namespace {

std::optional<double> real(Context& context, const Value& v) {
  if (v.is_number()) return v.as_number();
  if (v.is_integer() || v.is_bool()) return static_cast<double>(v.as_integer());
  context.fail(FaultKind::type, "must be real number, not " + std::string(type_name(v)));
  return std::nullopt;
}

Value domain(Context& context) { return context.fail(FaultKind::value, "math domain error"); }

// As Python's math_1: NaN from a number is undefined; infinity from a finite one is too large, or undefined.
template <typename Compute>
Value of_one(Context& context, Arguments arguments, Compute compute, bool can_overflow = false) {
  const auto x = real(context, arguments[0]);
  if (!x) return Value::unknown();
  const double result = compute(*x);
  if (std::isnan(result) && !std::isnan(*x)) return domain(context);
  if (std::isinf(result) && std::isfinite(*x)) {
    if (can_overflow) return context.fail(FaultKind::overflow, "math range error");
    return domain(context);
  }
  return Value(result);
}

template <typename Compute>
Value of_two(Context& context, Arguments arguments, Compute compute) {
  const auto x = real(context, arguments[0]);
  const auto y = x ? real(context, arguments[1]) : std::nullopt;
  if (!y) return Value::unknown();
  const double result = compute(*x, *y);
  if (std::isnan(result) && !std::isnan(*x) && !std::isnan(*y)) return domain(context);
  if (std::isinf(result) && std::isfinite(*x) && std::isfinite(*y))
    return context.fail(FaultKind::overflow, "math range error");
  return Value(result);
}

template <typename Compute>
Value to_integer(Context& context, Arguments arguments, Compute compute) {
  if (arguments[0].is_integer() || arguments[0].is_bool()) return Value(arguments[0].as_integer());
  const auto x = real(context, arguments[0]);
  if (!x) return Value::unknown();
  if (std::isnan(*x)) return context.fail(FaultKind::value, "cannot convert float NaN to integer");
  const double result = compute(*x);
  if (result >= 9223372036854775808.0 || result < -9223372036854775808.0)
    return context.fail(FaultKind::overflow, "integer out of 64 bits");
  return Value(static_cast<std::int64_t>(result));
}

// Logarithms of what is not positive are undefined.
template <typename Compute>
Value logarithm(Context& context, const Value& v, Compute compute) {
  const auto x = real(context, v);
  if (!x) return Value::unknown();
  return *x <= 0 ? domain(context) : Value(compute(*x));
}

}  // namespace

Value math_acos(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::acos(x); });
}
Value math_acosh(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::acosh(x); });
}
Value math_asin(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::asin(x); });
}
Value math_asinh(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::asinh(x); });
}
Value math_atan(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::atan(x); });
}
Value math_atanh(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::atanh(x); });
}
Value math_cos(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::cos(x); });
}
Value math_cosh(Context& c, Arguments a) {
  return of_one(
      c, a, [](double x) { return std::cosh(x); }, true);
}
Value math_exp(Context& c, Arguments a) {
  return of_one(
      c, a, [](double x) { return std::exp(x); }, true);
}
Value math_fabs(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::fabs(x); });
}
Value math_sin(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::sin(x); });
}
Value math_sinh(Context& c, Arguments a) {
  return of_one(
      c, a, [](double x) { return std::sinh(x); }, true);
}
Value math_sqrt(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::sqrt(x); });
}
Value math_tan(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::tan(x); });
}
Value math_tanh(Context& c, Arguments a) {
  return of_one(c, a, [](double x) { return std::tanh(x); });
}

Value math_degrees(Context& context, Arguments arguments) {
  const auto x = real(context, arguments[0]);
  return x ? Value(*x * (180.0 / M_PI)) : Value::unknown();
}

Value math_radians(Context& context, Arguments arguments) {
  const auto x = real(context, arguments[0]);
  return x ? Value(*x * (M_PI / 180.0)) : Value::unknown();
}

Value math_atan2(Context& c, Arguments a) {
  return of_two(c, a, [](double y, double x) { return std::atan2(y, x); });
}
Value math_copysign(Context& c, Arguments a) {
  return of_two(c, a, [](double x, double y) { return std::copysign(x, y); });
}
Value math_fmod(Context& c, Arguments a) {
  return of_two(c, a, [](double x, double y) { return std::fmod(x, y); });
}

Value math_pow(Context& context, Arguments arguments) {
  const auto x = real(context, arguments[0]);
  const auto y = x ? real(context, arguments[1]) : std::nullopt;
  if (!y) return Value::unknown();
  if (*x == 0 && *y < 0 && std::isfinite(*y)) return domain(context);
  return of_two(context, arguments, [](double a, double b) { return std::pow(a, b); });
}

Value math_ceil(Context& c, Arguments a) {
  return to_integer(c, a, [](double x) { return std::ceil(x); });
}
Value math_floor(Context& c, Arguments a) {
  return to_integer(c, a, [](double x) { return std::floor(x); });
}
Value math_trunc(Context& c, Arguments a) {
  return to_integer(c, a, [](double x) { return std::trunc(x); });
}

Value math_log(Context& context, Arguments arguments) {
  const auto natural = [](double x) { return std::log(x); };
  const Value numerator = logarithm(context, arguments[0], natural);
  if (context.failed || !given(arguments, 1)) return numerator;
  const Value denominator = logarithm(context, arguments[1], natural);
  if (context.failed) return denominator;
  if (denominator.as_number() == 0) return context.fail(FaultKind::zero_division, "float division by zero");
  return Value(numerator.as_number() / denominator.as_number());
}

Value math_log2(Context& context, Arguments arguments) {
  return logarithm(context, arguments[0], [](double x) { return std::log2(x); });
}
Value math_log10(Context& context, Arguments arguments) {
  return logarithm(context, arguments[0], [](double x) { return std::log10(x); });
}

// As Python's: scaled by the greatest, summed with the rounding errors kept, and corrected once.
Value math_hypot(Context& context, Arguments arguments) {
  std::vector<double> v;
  double greatest = 0;
  bool not_a_number = false;
  for (const Value& argument : arguments) {
    const auto x = real(context, argument);
    if (!x) return Value::unknown();
    not_a_number = not_a_number || std::isnan(*x);
    v.push_back(std::fabs(*x));
    greatest = std::max(greatest, v.back());
  }
  if (std::isinf(greatest)) return Value(greatest);
  if (not_a_number) return Value(std::nan(""));
  if (greatest == 0) return Value(0.0);
  int exponent = 0;
  std::frexp(greatest, &exponent);
  long double squares = 0;
  for (const double x : v) {
    const long double scaled = std::ldexp(static_cast<long double>(x), -exponent);
    squares += scaled * scaled;
  }
  const auto result = static_cast<double>(std::ldexp(std::sqrt(squares), exponent));
  return Value(result);
}

Value math_isclose(Context& context, Arguments arguments) {
  double v[4] = {0, 0, 1e-9, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!given(arguments, i)) continue;
    const auto x = real(context, arguments[i]);
    if (!x) return Value::unknown();
    v[i] = *x;
  }
  if (v[2] < 0 || v[3] < 0) return context.fail(FaultKind::value, "tolerances must be non-negative");
  if (v[0] == v[1]) return Value(true);
  if (std::isinf(v[0]) || std::isinf(v[1])) return Value(false);
  const double difference = std::fabs(v[1] - v[0]);
  return Value(difference <= std::fabs(v[2] * v[1]) || difference <= std::fabs(v[2] * v[0]) || difference <= v[3]);
}

Value math_isfinite(Context& context, Arguments arguments) {
  const auto x = real(context, arguments[0]);
  return x ? Value(std::isfinite(*x)) : Value::unknown();
}
Value math_isinf(Context& context, Arguments arguments) {
  const auto x = real(context, arguments[0]);
  return x ? Value(std::isinf(*x)) : Value::unknown();
}
Value math_isnan(Context& context, Arguments arguments) {
  const auto x = real(context, arguments[0]);
  return x ? Value(std::isnan(*x)) : Value::unknown();
}

}  // namespace race::language::library
