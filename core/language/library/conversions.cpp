// bool, int, float, str, list, dict.
#include <charconv>
#include <cmath>

#include "core/language/library/library_internal.h"
#include "core/language/primitives/numbers.h"
#include "core/language/primitives/unicode.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/printing.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {
namespace {

// The text of a number: without space around it, other decimal digits as ASCII ones, without underscores between
// digits. Nothing if there are underscores elsewhere.
std::optional<std::string> number_text(const std::string& text) {
  const std::u32string decoded = utf8::decode(text);
  std::u32string_view points = decoded;
  while (!points.empty() && unicode::is_space(points.back())) points.remove_suffix(1);
  while (!points.empty() && unicode::is_space(points.front())) points.remove_prefix(1);
  std::string out;
  bool digit_before = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char32_t p = points[i];
    if (p == '_') {
      if (!digit_before || i + 1 == points.size()) return std::nullopt;
      const char32_t after = points[i + 1];
      if (!unicode::is_decimal(after) && !(after < 0x80 && unicode::is_alpha(after))) return std::nullopt;
      digit_before = false;
      continue;
    }
    digit_before = unicode::is_decimal(p) || (p < 0x80 && unicode::is_alpha(p));
    if (p < 0x80) {
      out += static_cast<char>(p);
    } else if (unicode::is_decimal(p)) {
      out += static_cast<char>('0' + unicode::decimal_value(p));
    } else {
      return std::nullopt;
    }
  }
  return out;
}

Value invalid_integer(Context& context, const Value& v, std::int64_t base) {
  return context.fail(FaultKind::value, "invalid literal for int() with base " + std::to_string(base) + ": " + repr(v));
}

// int(text, base)
Value integer_of_text(Context& context, const Value& v, std::int64_t base) {
  if (!context.charge(work::made(1) + work::characters(v.as_string().size()))) return Value::unknown();
  const auto text = number_text(v.as_string());
  if (!text) return invalid_integer(context, v, base);
  std::string_view digits = *text;
  const bool negative = !digits.empty() && digits[0] == '-';
  if (negative || (!digits.empty() && digits[0] == '+')) digits.remove_prefix(1);
  int actual = static_cast<int>(base);
  if (digits.size() > 1 && digits[0] == '0') {
    const char kind = static_cast<char>(digits[1] | 0x20);
    const int prefix = kind == 'x' ? 16 : kind == 'o' ? 8 : kind == 'b' ? 2 : 0;
    if (prefix != 0 && (base == 0 || base == prefix)) {
      digits.remove_prefix(2);
      actual = prefix;
    } else if (base == 0 && digits.find_first_not_of('0') != std::string_view::npos) {
      return invalid_integer(context, v, base);
    }
  }
  if (actual == 0) actual = 10;
  if (digits.empty() || digits[0] == '-' || digits[0] == '+') return invalid_integer(context, v, base);
  const std::string signed_digits = (negative ? "-" : "") + std::string(digits);
  std::int64_t value = 0;
  const char* end = signed_digits.data() + signed_digits.size();
  const auto [stop, error] = std::from_chars(signed_digits.data(), end, value, actual);
  if (stop != end || error == std::errc::invalid_argument) return invalid_integer(context, v, base);
  if (error == std::errc::result_out_of_range) return context.fail(FaultKind::overflow, "integer out of 64 bits");
  return Value(value);
}

}  // namespace

Value to_bool(Context&, Arguments arguments) { return Value(given(arguments, 0) && truth(arguments[0])); }

Value to_int(Context& context, Arguments arguments) {
  if (!given(arguments, 0)) {
    if (given(arguments, 1)) return context.fail(FaultKind::type, "int() missing string argument");
    return Value(0);
  }
  const Value& v = arguments[0];
  if (given(arguments, 1)) {
    const auto base = integer(context, arguments[1]);
    if (!base) return Value::unknown();
    if (!v.is_string()) return context.fail(FaultKind::type, "int() can't convert non-string with explicit base");
    if (*base != 0 && (*base < 2 || *base > 36))
      return context.fail(FaultKind::value, "int() base must be >= 2 and <= 36, or 0");
    return integer_of_text(context, v, *base);
  }
  if (v.is_integer() || v.is_bool()) return Value(v.as_integer());
  if (v.is_string()) return integer_of_text(context, v, 10);
  if (!v.is_number())
    return context.fail(FaultKind::type,
                        "int() argument must be a string or a real number, not '" + std::string(type_name(v)) + "'");
  const double d = v.as_number();
  if (std::isnan(d)) return context.fail(FaultKind::value, "cannot convert float NaN to integer");
  const double whole = std::trunc(d);
  if (whole >= 9223372036854775808.0 || whole < -9223372036854775808.0)
    return context.fail(FaultKind::overflow, "integer out of 64 bits");
  return Value(static_cast<std::int64_t>(whole));
}

Value to_float(Context& context, Arguments arguments) {
  if (!given(arguments, 0)) return Value(0.0);
  const Value& v = arguments[0];
  if (v.is_number()) return v;
  if (v.is_integer() || v.is_bool()) return Value(static_cast<double>(v.as_integer()));
  if (!v.is_string())
    return context.fail(FaultKind::type,
                        "float() argument must be a string or a real number, not '" + std::string(type_name(v)) + "'");
  if (!context.charge(work::made(1) + work::characters(v.as_string().size()))) return Value::unknown();
  const auto text = number_text(v.as_string());
  const auto value = text ? parse_float(*text) : std::nullopt;
  return value ? Value(*value) : context.fail(FaultKind::value, "could not convert string to float: " + repr(v));
}

Value to_str(Context& context, Arguments arguments) {
  if (!given(arguments, 0)) return Value("");
  if (arguments[0].is_string()) return arguments[0];
  if (!charge_printing(context, arguments[0])) return Value::unknown();
  std::string text = str(arguments[0]);
  return check_units(context, text.size()) ? Value(std::move(text)) : Value::unknown();
}

Value to_list(Context& context, Arguments arguments) {
  if (!given(arguments, 0)) return Value(List());
  Value items = elements(context, arguments[0]);
  return context.failed ? items : within_limits(context, std::move(items));
}

// dict(other), dict(pairs), dict(name=value, ...): the names follow as pairs
Value to_dict(Context& context, Arguments arguments) {
  Dict entries;
  if (given(arguments, 0) && arguments[0].is_dict()) {
    if (!context.charge(work::entries(arguments[0].as_dict().size()))) return Value::unknown();
    entries = arguments[0].as_dict();
  } else if (given(arguments, 0)) {
    const Value pairs = elements(context, arguments[0]);
    if (context.failed) return pairs;
    for (const Value& item : pairs.as_list()) {
      const Value pair = elements(context, item);
      if (context.failed) return pair;
      if (pair.as_list().size() != 2)
        return context.fail(FaultKind::value, "dictionary update sequence element must have length 2");
      if (!pair.as_list()[0].is_string()) return context.fail(FaultKind::type, "keys of a dict must be str");
      if (!context.charge(work::sets(1) + work::block(pair.as_list()[0].as_string().size()))) return Value::unknown();
      entries.set(pair.as_list()[0], pair.as_list()[1]);
    }
  }
  if (!context.charge(work::sets(arguments.size() / 2))) return Value::unknown();
  for (std::size_t i = 1; i + 1 < arguments.size(); i += 2) entries.set(arguments[i], arguments[i + 1]);
  return within_limits(context, Value(std::move(entries)));
}

}  // namespace race::language::library
