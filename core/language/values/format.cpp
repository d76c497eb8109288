// Format specifications: [[fill]align][sign][z][#][0][width][,|_][.precision][type], as Python's.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/language/primitives/numbers.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/printing.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language {
namespace {

struct Specification {
  std::string fill = " ";
  char align = 0;
  char sign = 0;  // none given: as '-'
  bool no_negative_zero = false;
  bool alternate = false;
  std::int64_t width = 0;
  char grouping = 0;
  std::int64_t precision = -1;
  char type = 0;
};

Value bad(Context& context, std::string message) { return context.fail(FaultKind::value, std::move(message)); }

bool is_align(char32_t c) { return c == '<' || c == '>' || c == '=' || c == '^'; }

// Reads a number; false if it is larger than a value may be.
bool read_number(std::u32string_view text, std::size_t& at, std::int64_t& number, Context& context) {
  number = 0;
  for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
    number = number * 10 + static_cast<std::int64_t>(text[at] - '0');
    if (!check_units(context, static_cast<std::uint64_t>(number))) return false;
  }
  return true;
}

std::optional<Specification> parse_specification(Context& context, std::string_view source, char default_align) {
  const std::u32string text = utf8::decode(source);
  Specification s;
  std::size_t at = 0;
  const auto is = [&](char32_t c) { return at < text.size() && text[at] == c; };
  bool filled = false;
  if (text.size() > 1 && is_align(text[1])) {
    s.fill = utf8::encode(text.substr(0, 1));
    s.align = static_cast<char>(text[1]);
    filled = true;
    at = 2;
  } else if (!text.empty() && is_align(text[0])) {
    s.align = static_cast<char>(text[0]);
    at = 1;
  }
  if (is('+') || is('-') || is(' ')) s.sign = static_cast<char>(text[at++]);
  if (is('z')) s.no_negative_zero = true, ++at;
  if (is('#')) s.alternate = true, ++at;
  if (!filled && is('0')) {
    s.fill = "0";
    if (s.align == 0 && default_align == '>') s.align = '=';
    ++at;
  }
  if (!read_number(text, at, s.width, context)) return std::nullopt;
  if (is(',')) s.grouping = ',', ++at;
  if (is('_')) {
    if (s.grouping != 0) return bad(context, "Cannot specify both ',' and '_'."), std::nullopt;
    s.grouping = '_';
    ++at;
  }
  if (is(',')) return bad(context, "Cannot specify both ',' and '_'."), std::nullopt;
  if (is('.')) {
    const std::size_t digits = ++at;
    if (!read_number(text, at, s.precision, context)) return std::nullopt;
    if (at == digits) return bad(context, "Format specifier missing precision"), std::nullopt;
  }
  if (text.size() - at > 1) return bad(context, "Invalid format specifier"), std::nullopt;
  if (at < text.size()) s.type = text[at] < 0x80 ? static_cast<char>(text[at]) : '?';
  if (s.align == 0) s.align = default_align;
  if (!context.charge(work::characters(source.size() +
                                       static_cast<std::uint64_t>(s.width + std::max<std::int64_t>(s.precision, 0))) /
                      4))
    return std::nullopt;
  const std::string_view plain = "deEfFgG%";
  const bool grouped = s.type == 0 || plain.find(s.type) != plain.npos;
  const bool by_four = s.grouping == '_' && (s.type == 'b' || s.type == 'o' || s.type == 'x' || s.type == 'X');
  if (s.grouping != 0 && !grouped && !by_four)
    return bad(context, std::string("Cannot specify '") + s.grouping + "' with '" + s.type + "'."), std::nullopt;
  return s;
}

// `digits` with a separator after every `size` from the right, and zeros before them up to `width`.
std::string group(std::string digits, char separator, std::size_t size, std::int64_t width) {
  const auto length = [&](std::size_t n) { return separator == 0 ? n : n + (n - 1) / size; };
  std::size_t zeros = 0;
  while (static_cast<std::int64_t>(length(digits.size() + zeros)) < width) ++zeros;
  digits.insert(0, zeros, '0');
  if (separator == 0) return digits;
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % size == 0) out += separator;
    out += digits[i];
  }
  return out;
}

// Joins sign, prefix, digits and the rest, and pads them.
Value laid_out(Context& context, const Specification& s, std::string before, std::string digits, std::string after) {
  const std::size_t size = s.type == 'b' || s.type == 'o' || s.type == 'x' || s.type == 'X' ? 4 : 3;
  const bool zeros = s.fill == "0" && s.align == '=';
  const auto rest = static_cast<std::int64_t>(before.size() + utf8::length(after));
  if (!digits.empty()) digits = group(std::move(digits), s.grouping, size, zeros ? s.width - rest : 0);
  const std::int64_t missing = s.width - rest - static_cast<std::int64_t>(digits.size());
  if (missing > 0 && !check_units(context, static_cast<std::uint64_t>(missing) * s.fill.size()))
    return Value::unknown();
  const auto fill = [&](std::int64_t count) {
    std::string text;
    for (std::int64_t i = 0; i < count; ++i) text += s.fill;
    return text;
  };
  const std::string body = before + digits + after;
  switch (s.align) {
    case '<':
      return Value(body + fill(missing));
    case '^':
      return Value(fill(missing / 2) + body + fill(missing - missing / 2));
    case '=':
      return Value(before + fill(missing) + digits + after);
    default:
      return Value(fill(missing) + body);
  }
}

std::string sign_of(const Specification& s, bool negative) {
  if (negative) return "-";
  return s.sign == '-' || s.sign == 0 ? std::string() : std::string(1, s.sign);
}

Value format_text(Context& context, const Value& v, std::string_view source) {
  const auto s = parse_specification(context, source, '<');
  if (!s) return Value::unknown();
  if (s->type != 0 && s->type != 's') return bad(context, "Unknown format code for object of type 'str'");
  if (s->sign != 0) return bad(context, "Sign not allowed in string format specifier");
  if (s->alternate || s->no_negative_zero || s->align == '=' || s->grouping != 0)
    return bad(context, "not allowed in string format specifier");
  if (!context.charge(work::search(v.as_string().size()))) return Value::unknown();
  std::string text = v.as_string();
  if (s->precision >= 0) text = text.substr(0, utf8::offset(text, static_cast<std::size_t>(s->precision)));
  return laid_out(context, *s, "", "", std::move(text));
}

Value format_integer(Context& context, std::int64_t v, const Specification& s) {
  if (s.precision >= 0) return bad(context, "Precision not allowed in integer format specifier");
  if (s.no_negative_zero)
    return bad(context, "Negative zero coercion (z) not allowed in format specifier with integer");
  if (s.type == 'c') {
    if (s.sign != 0 || s.alternate) return bad(context, "not allowed with integer format specifier 'c'");
    if (v < 0 || v > 0x10FFFF) return context.fail(FaultKind::overflow, "%c arg not in range(0x110000)");
    if (v >= 0xD800 && v <= 0xDFFF) return bad(context, "a surrogate is no character");
    return laid_out(context, s, "", "", utf8::encode(std::u32string(1, static_cast<char32_t>(v))));
  }
  const char kind = static_cast<char>(s.type | 0x20);
  const int base = kind == 'x' ? 16 : kind == 'o' ? 8 : kind == 'b' ? 2 : 10;
  const auto magnitude = v < 0 ? ~static_cast<std::uint64_t>(v) + 1 : static_cast<std::uint64_t>(v);
  char buffer[72];
  const char* end = std::to_chars(buffer, buffer + sizeof buffer, magnitude, base).ptr;
  std::string digits(buffer, static_cast<std::size_t>(end - buffer));
  std::string before = sign_of(s, v < 0);
  if (s.alternate && base != 10) before += std::string("0") + s.type;
  if (s.type == 'X')
    std::transform(digits.begin(), digits.end(), digits.begin(),
                   [](char c) { return c >= 'a' ? static_cast<char>(c - 32) : c; });
  return laid_out(context, s, std::move(before), std::move(digits), "");
}

// `digits` of |v| and what follows them, for one of the types e, f, g; `dot` keeps a fraction (type none).
std::string real_text(double v, char kind, int precision, bool alternate, bool dot) {
  std::string text(static_cast<std::size_t>(precision) + 330, '\0');
  const auto chars = [&](std::chars_format how, int digits) {
    const char* end = std::to_chars(text.data(), text.data() + text.size(), v, how, digits).ptr;
    return std::string(text.data(), static_cast<std::size_t>(end - text.data()));
  };
  if (kind != 'g') {
    std::string out = chars(kind == 'e' ? std::chars_format::scientific : std::chars_format::fixed, precision);
    if (alternate && precision == 0) out.insert(std::min(out.find('e'), out.size()), ".");
    return out;
  }
  precision = std::max(precision, 1);
  const std::string scientific = chars(std::chars_format::scientific, precision - 1);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  const bool exponential = exponent < -4 || exponent >= precision - (dot ? 1 : 0);
  std::string out = exponential ? scientific : chars(std::chars_format::fixed, precision - 1 - exponent);
  std::string tail;
  if (const std::size_t e = out.find('e'); e != std::string::npos) {
    tail = out.substr(e);
    out.resize(e);
  }
  if (!alternate && out.find('.') != std::string::npos) {
    out.resize(out.find_last_not_of('0') + 1);
    if (out.back() == '.') out.pop_back();
  }
  if (alternate && out.find('.') == std::string::npos) out += '.';
  if (dot && !exponential && out.find('.') == std::string::npos) out += ".0";
  return out + tail;
}

Value format_real(Context& context, double v, Specification s) {
  constexpr std::int64_t kMostDigits = 10'000;
  if (s.precision > kMostDigits) return bad(context, "precision too big");
  const bool percent = s.type == '%';
  const char kind = percent ? 'f' : s.type == 0 || s.type == 'n' ? 'g' : static_cast<char>(s.type | 0x20);
  if (percent) v *= 100;
  std::string text;
  if (!std::isfinite(v)) {
    text = std::isnan(v) ? "nan" : "inf";
  } else if (s.type == 0 && s.precision < 0) {
    text = repr(std::fabs(v));
    if (s.alternate && text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".");
  } else {
    text = real_text(std::fabs(v), kind, static_cast<int>(s.precision < 0 ? 6 : s.precision), s.alternate, s.type == 0);
  }
  bool negative = std::signbit(v) && !std::isnan(v);
  if (s.no_negative_zero && text.substr(0, text.find('e')).find_first_of("123456789") == std::string::npos &&
      std::isfinite(v))
    negative = false;
  if (s.type == 'E' || s.type == 'F' || s.type == 'G')
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' ? static_cast<char>(c - 32) : c; });
  const bool number = std::isfinite(v);
  const std::size_t whole = number ? std::min(text.find_first_not_of("0123456789"), text.size()) : 0;
  return laid_out(context, s, sign_of(s, negative), text.substr(0, whole), text.substr(whole) + (percent ? "%" : ""));
}

}  // namespace

Value formatted(Context& context, const Value& v, std::string_view specification) {
  if (specification.empty()) {
    if (!v.is_string() && !charge_printing(context, v)) return Value::unknown();
    std::string text = str(v);
    return check_units(context, text.size()) ? Value(std::move(text)) : Value::unknown();
  }
  if (v.is_string()) return format_text(context, v, specification);
  if (!v.is_numeric() && !v.is_bool())
    return context.fail(FaultKind::type,
                        "unsupported format string passed to " + std::string(type_name(v)) + ".__format__");
  const auto s = parse_specification(context, specification, '>');
  if (!s || !context.charge(3 * work::made(1))) return Value::unknown();
  const std::string_view of_reals = "eEfFgG%";
  const std::string_view of_integers = "bcdnoxX";
  const bool real_type = s->type != 0 && of_reals.find(s->type) != of_reals.npos;
  const bool integer_type = s->type != 0 && of_integers.find(s->type) != of_integers.npos;
  if (!real_type && !integer_type && s->type != 0)
    return bad(context, "Unknown format code '" + std::string(1, s->type) + "'");
  if (v.is_number()) {
    if (integer_type && s->type != 'n') return bad(context, "Unknown format code for object of type 'float'");
    return format_real(context, v.as_number(), *s);
  }
  if (real_type) return format_real(context, static_cast<double>(v.as_integer()), *s);
  return format_integer(context, v.as_integer(), *s);
}

}  // namespace race::language
