// Methods of str that split, join, strip and pad.
#include <algorithm>
#include <bit>

#include "core/language/library/library_internal.h"
#include "core/language/primitives/search.h"
#include "core/language/primitives/unicode.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {
namespace {

// An optional text argument: null where None or nothing was given; false after a fault.
bool text_or_none(Context& context, Arguments arguments, std::size_t i, const std::string*& out) {
  const Value& v = optional(arguments, i);
  out = v.is_string() ? &v.as_string() : nullptr;
  if (v.is_string() || v.is_null() || v.is_unknown()) return true;
  context.fail(FaultKind::type, "must be str or None, not " + std::string(type_name(v)));
  return false;
}

// Without the characters `chars` (space if null) at the left, the right or both ends.
Value stripped(Context& context, const Value& self, Arguments arguments, bool left, bool right) {
  const std::string* chars = nullptr;
  if (!text_or_none(context, arguments, 0, chars)) return Value::unknown();
  const std::uint64_t set_size = chars == nullptr ? 1 : chars->size();
  // The set is sorted, and searched for each character.
  if (!context.charge(work::characters((self.as_string().size() + set_size) * std::bit_width(set_size)) / 2))
    return Value::unknown();
  const std::u32string points = utf8::decode(self.as_string());
  std::u32string set = chars == nullptr ? std::u32string() : utf8::decode(*chars);
  std::ranges::sort(set);
  const auto drops = [&](char32_t p) {
    return chars == nullptr ? unicode::is_space(p) : std::ranges::binary_search(set, p);
  };
  std::size_t begin = 0;
  std::size_t end = points.size();
  while (left && begin < end && drops(points[begin])) ++begin;
  while (right && end > begin && drops(points[end - 1])) --end;
  return Value(utf8::encode(std::u32string_view(points).substr(begin, end - begin)));
}

// `found`, whose strings have been made; unknown and a fault if that was too much.
Value made_list(Context& context, List found) {
  if (!context.charge(2 * work::made(found.size()))) return Value::unknown();
  return within_limits(context, Value(std::move(found)));
}

// The words between runs of space, from the left or the right, at most `most` + 1 of them.
List words(std::string_view text, std::int64_t most, bool from_right) {
  const std::u32string decoded = utf8::decode(text);
  std::u32string points = decoded;
  if (from_right) std::reverse(points.begin(), points.end());
  List found;
  const auto put = [&](std::size_t begin, std::size_t end) {
    std::u32string word = points.substr(begin, end - begin);
    if (from_right) std::reverse(word.begin(), word.end());
    found.emplace_back(utf8::encode(word));
  };
  std::size_t at = 0;
  for (;;) {
    while (at < points.size() && unicode::is_space(points[at])) ++at;
    if (at == points.size()) break;
    if (most-- == 0) {
      put(at, points.size());
      break;
    }
    const std::size_t begin = at;
    while (at < points.size() && !unicode::is_space(points[at])) ++at;
    put(begin, at);
  }
  if (from_right) std::reverse(found.begin(), found.end());
  return found;
}

List pieces(std::string_view text, std::string_view separator, std::int64_t most) {
  List found;
  while (most-- != 0) {
    const std::size_t at = find_first(text, separator);
    if (at == kNowhere) break;
    found.emplace_back(text.substr(0, at));
    text = text.substr(at + separator.size());
  }
  found.emplace_back(text);
  return found;
}

List pieces_from_right(std::string_view text, std::string_view separator, std::int64_t most) {
  List found = pieces(mirrored(text), mirrored(separator), most);
  for (Value& piece : found) piece = Value(mirrored(piece.as_string()));
  std::ranges::reverse(found);
  return found;
}

Value split(Context& context, const Value& self, Arguments arguments, bool from_right) {
  const std::string* separator = nullptr;
  if (!text_or_none(context, arguments, 0, separator)) return Value::unknown();
  std::int64_t most = -1;
  if (given(arguments, 1)) {
    const auto limit = integer(context, arguments[1]);
    if (!limit) return Value::unknown();
    most = *limit;
  }
  if (!context.charge(separator == nullptr ? work::characters(self.as_string().size())
                                           : work::search(self.as_string().size() + separator->size())))
    return Value::unknown();
  if (separator == nullptr) return made_list(context, words(self.as_string(), most, from_right));
  if (separator->empty()) return context.fail(FaultKind::value, "empty separator");
  const auto divide = from_right ? pieces_from_right : pieces;
  return made_list(context, divide(self.as_string(), *separator, most));
}

// Pads to arguments[0] code points with arguments[1]; `left` of all that is missing goes before the text.
template <typename Left>
Value padded(Context& context, const Value& self, Arguments arguments, Left left) {
  const auto width = integer(context, arguments[0]);
  if (!width) return Value::unknown();
  std::string fill = " ";
  if (given(arguments, 1)) {
    if (!arguments[1].is_string() || utf8::length(arguments[1].as_string()) != 1)
      return context.fail(FaultKind::type, "The fill character must be exactly one character long");
    fill = arguments[1].as_string();
  }
  if (!context.charge(work::scan(self.as_string().size()))) return Value::unknown();
  const auto size = static_cast<std::int64_t>(utf8::length(self.as_string()));
  if (*width <= size) return self;
  if (!check_units(context, static_cast<std::uint64_t>(*width)) ||
      !check_units(context, static_cast<std::uint64_t>(*width - size) * fill.size() + self.as_string().size()))
    return Value::unknown();
  if (!context.charge(work::characters(static_cast<std::uint64_t>(*width)) / 2)) return Value::unknown();
  const std::int64_t before = left(*width - size, *width);
  std::string out;
  for (std::int64_t i = 0; i < before; ++i) out += fill;
  out += self.as_string();
  for (std::int64_t i = before; i < *width - size; ++i) out += fill;
  return Value(std::move(out));
}

}  // namespace

Value str_strip(Context& context, const Value& self, Arguments arguments) {
  return stripped(context, self, arguments, true, true);
}
Value str_lstrip(Context& context, const Value& self, Arguments arguments) {
  return stripped(context, self, arguments, true, false);
}
Value str_rstrip(Context& context, const Value& self, Arguments arguments) {
  return stripped(context, self, arguments, false, true);
}

Value str_split(Context& context, const Value& self, Arguments arguments) {
  return split(context, self, arguments, false);
}
Value str_rsplit(Context& context, const Value& self, Arguments arguments) {
  return split(context, self, arguments, true);
}

Value str_splitlines(Context& context, const Value& self, Arguments arguments) {
  const bool keep = given(arguments, 0) && truth(arguments[0]);
  const std::string_view text = self.as_string();
  if (!context.charge(work::characters(text.size()) / 4)) return Value::unknown();
  const auto ends = [](char32_t p) {
    return (p >= 0x0A && p <= 0x0D) || (p >= 0x1C && p <= 0x1E) || p == 0x85 || p == 0x2028 || p == 0x2029;
  };
  List lines;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = at;
    if (!ends(utf8::next(text, at))) continue;
    if (text[end] == '\r' && at < text.size() && text[at] == '\n') ++at;
    lines.emplace_back(text.substr(begin, (keep ? at : end) - begin));
    begin = at;
  }
  if (begin < text.size()) lines.emplace_back(text.substr(begin));
  return made_list(context, std::move(lines));
}

Value str_join(Context& context, const Value& self, Arguments arguments) {
  const Value items = elements(context, arguments[0]);
  if (context.failed) return items;
  std::string out;
  bool first = true;
  for (const Value& item : items.as_list()) {
    if (!item.is_string())
      return context.fail(FaultKind::type,
                          "sequence item: expected str instance, " + std::string(type_name(item)) + " found");
    const std::size_t size = item.as_string().size() + (first ? 0 : self.as_string().size());
    if (!check_units(context, out.size() + size) || !context.charge(1 + work::block(size))) return Value::unknown();
    if (!first) out += self.as_string();
    first = false;
    out += item.as_string();
  }
  return Value(std::move(out));
}

Value str_ljust(Context& context, const Value& self, Arguments arguments) {
  return padded(context, self, arguments, [](std::int64_t, std::int64_t) { return std::int64_t{0}; });
}
Value str_rjust(Context& context, const Value& self, Arguments arguments) {
  return padded(context, self, arguments, [](std::int64_t missing, std::int64_t) { return missing; });
}
Value str_center(Context& context, const Value& self, Arguments arguments) {
  return padded(context, self, arguments,
                [](std::int64_t missing, std::int64_t width) { return missing / 2 + (missing & width & 1); });
}

Value str_zfill(Context& context, const Value& self, Arguments arguments) {
  const std::string& text = self.as_string();
  if (!context.charge(work::block(2 * text.size()))) return Value::unknown();
  const bool sign = !text.empty() && (text[0] == '+' || text[0] == '-');
  const Value digits = sign ? Value(text.substr(1)) : self;
  const auto width = integer(context, arguments[0]);
  if (!width) return Value::unknown();
  const Value parts[2] = {Value(sign && *width > INT64_MIN ? *width - 1 : *width), Value("0")};
  const Value filled = str_rjust(context, digits, parts);
  return sign && filled.is_string() ? Value(text.substr(0, 1) + filled.as_string()) : filled;
}

}  // namespace race::language::library
