#include "core/language/primitives/numbers.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace race::language {
namespace {

__extension__ using Wide = unsigned __int128;

int bits(std::uint64_t v) { return v == 0 ? 0 : 64 - __builtin_clzll(v); }

// Whether a decimal number that is out of range is too small: by the position of its first significant digit.
bool underflows(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == std::string_view::npos) return true;
  if (e != std::string_view::npos && text.substr(e + 1).front() == '-') return true;
  if (e != std::string_view::npos) return false;
  const std::size_t point = mantissa.find('.');
  return point != std::string_view::npos && first > point;
}

}  // namespace

std::optional<double> parse_float(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative || (!text.empty() && text.front() == '+')) text.remove_prefix(1);
  if (text.empty() || text.front() == '-' || text.front() == '+') return std::nullopt;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  double value = 0;
  if (!digit(text.front()) && text.front() != '.') {
    std::string lower;
    for (const char c : text) lower += static_cast<char>(c | 0x20);
    if (lower == "nan") {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (lower == "inf" || lower == "infinity") {
      value = std::numeric_limits<double>::infinity();
    } else {
      return std::nullopt;
    }
  } else {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return std::nullopt;
    if (error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc::result_out_of_range)
      value = underflows(text) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return negative ? -value : value;
}

std::string repr(double v) {
  if (std::isnan(v)) return "nan";
  if (std::isinf(v)) return v < 0 ? "-inf" : "inf";
  char buffer[40];
  const char* end = std::to_chars(buffer, buffer + sizeof buffer, v, std::chars_format::scientific).ptr;
  std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  std::string out;
  if (text.front() == '-') {
    out += '-';
    text.remove_prefix(1);
  }
  const std::size_t e = text.find('e');
  std::string digits(text.substr(0, 1));
  if (e > 2) digits += text.substr(2, e - 2);
  int exponent = 0;
  const std::size_t sign = text[e + 1] == '+' ? e + 2 : e + 1;
  std::from_chars(text.data() + sign, text.data() + text.size(), exponent);
  const int count = static_cast<int>(digits.size());
  if (exponent < -4 || exponent >= 16) {
    out += digits.substr(0, 1);
    if (count > 1) out += '.' + digits.substr(1);
    const std::string number = std::to_string(std::abs(exponent));
    return out + (exponent < 0 ? "e-" : "e+") + (number.size() < 2 ? "0" : "") + number;
  }
  if (exponent < 0) return out + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  const auto whole = static_cast<std::size_t>(exponent + 1);
  if (digits.size() <= whole) return out + digits + std::string(whole - digits.size(), '0') + ".0";
  return out + digits.substr(0, whole) + '.' + digits.substr(whole);
}

double true_divide(std::int64_t a, std::int64_t b) {
  constexpr std::int64_t kExact = std::int64_t{1} << 53;
  if (a >= -kExact && a <= kExact && b >= -kExact && b <= kExact)
    return static_cast<double>(a) / static_cast<double>(b);
  // At least 64 bits of the quotient and a sticky bit: converting them rounds once.
  const bool negative = (a < 0) != (b < 0);
  const auto magnitude = [](std::int64_t v) {
    return v < 0 ? ~static_cast<std::uint64_t>(v) + 1 : static_cast<std::uint64_t>(v);
  };
  if (a == 0) return negative ? -0.0 : 0.0;
  const int shift = 127 - bits(magnitude(a));
  const Wide dividend = static_cast<Wide>(magnitude(a)) << shift;
  Wide quotient = dividend / magnitude(b);
  if (dividend % magnitude(b) != 0) quotient |= 1;
  const double result = std::ldexp(static_cast<double>(quotient), -shift);
  return negative ? -result : result;
}

double floor_modulo(double a, double b) {
  double remainder = std::fmod(a, b);
  if (remainder != 0) return (b < 0) != (remainder < 0) ? remainder + b : remainder;
  return std::copysign(0.0, b);
}

double floor_divide(double a, double b) {
  double remainder = std::fmod(a, b);
  double quotient = (a - remainder) / b;
  if (remainder != 0 && (b < 0) != (remainder < 0)) quotient -= 1.0;
  if (quotient == 0) return std::copysign(0.0, a / b);
  const double floored = std::floor(quotient);
  return quotient - floored > 0.5 ? floored + 1.0 : floored;
}

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  const std::int64_t quotient = a / b;
  return a % b != 0 && (a % b < 0) != (b < 0) ? quotient - 1 : quotient;
}

std::int64_t floor_modulo(std::int64_t a, std::int64_t b) {
  const std::int64_t remainder = a % b;
  return remainder != 0 && (remainder < 0) != (b < 0) ? remainder + b : remainder;
}

std::optional<std::int64_t> power(std::int64_t base, std::int64_t exponent) {
  std::int64_t result = 1;
  for (;;) {
    if ((exponent & 1) != 0 && __builtin_mul_overflow(result, base, &result)) return std::nullopt;
    exponent >>= 1;
    if (exponent == 0) return result;
    if (__builtin_mul_overflow(base, base, &base)) {
      // The square is needed, for `exponent` is not 0 yet, and no later factor brings it back into range.
      return std::nullopt;
    }
  }
}

int compare(std::int64_t i, double d) {
  if (d >= 9223372036854775808.0) return -1;
  if (d < -9223372036854775808.0) return 1;
  const auto whole = static_cast<std::int64_t>(d);
  if (i != whole) return i < whole ? -1 : 1;
  const double rest = d - static_cast<double>(whole);
  return rest > 0 ? -1 : rest < 0 ? 1 : 0;
}

double round_decimal(double v, int digits) {
  if (digits > 323 || v == 0) return v;
  if (digits < -308) return std::copysign(0.0, v);
  char buffer[800];
  if (digits >= 0) {
    const char* end = std::to_chars(buffer, buffer + sizeof buffer, v, std::chars_format::fixed, digits).ptr;
    return *parse_float(std::string_view(buffer, static_cast<std::size_t>(end - buffer)));
  }
  // Tens: the digits of the whole part, rounded by hand; a fraction below them only breaks a tie.
  const double whole = std::trunc(std::fabs(v));
  const char* end = std::to_chars(buffer, buffer + sizeof buffer, whole, std::chars_format::fixed, 0).ptr;
  const std::string text_of_whole(buffer, static_cast<std::size_t>(end - buffer));
  std::string text = '0' + text_of_whole;
  const auto dropped = static_cast<std::size_t>(-digits);
  if (dropped >= text.size()) return std::copysign(0.0, v);
  const std::size_t kept = text.size() - dropped;
  const bool more = text.find_first_not_of('0', kept + 1) != std::string::npos || whole != std::fabs(v);
  const bool odd = ((text[kept - 1] - '0') & 1) != 0;
  const bool up = text[kept] > '5' || (text[kept] == '5' && (more || odd));
  text.replace(kept, dropped, dropped, '0');
  for (std::size_t i = kept; up && i-- > 0;) {
    if (text[i] != '9') {
      ++text[i];
      break;
    }
    text[i] = '0';
  }
  return std::copysign(*parse_float(text), v);
}

}  // namespace race::language
