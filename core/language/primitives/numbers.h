// Numbers and texts: the parts of Python's number formatting and arithmetic that C++ does not have.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace race::language {

/// Reads `[sign] digits [. digits] [e [sign] digits]`, `inf`, `infinity` or `nan` (any case), nothing around it. Too
/// large gives infinity, too small 0.
std::optional<double> parse_float(std::string_view text);

/// The shortest text that reads back as `v`, as Python's repr: 1.0, 1e+16, 0.0001, 1e-05, inf, nan.
std::string repr(double v);

/// `a / b` of two integers, rounded once. Requires b != 0.
double true_divide(std::int64_t a, std::int64_t b);

/// Python's // and % of doubles: the remainder has the sign of b. Requires b != 0.
double floor_divide(double a, double b);
double floor_modulo(double a, double b);

/// Python's // and % of integers. Requires b != 0 and not (a = -2^63 and b = -1).
std::int64_t floor_divide(std::int64_t a, std::int64_t b);
std::int64_t floor_modulo(std::int64_t a, std::int64_t b);

/// base ** exponent; nothing if it does not fit. Requires exponent >= 0.
std::optional<std::int64_t> power(std::int64_t base, std::int64_t exponent);

/// The sign of i - d, exactly; d is not NaN.
int compare(std::int64_t i, double d);

/// Rounds to `digits` decimal places (negative: tens), half to even on the exact value. Finite v.
double round_decimal(double v, int digits);

}  // namespace race::language
