// Methods of str about classes and cases of characters.
#include "core/language/library/library_internal.h"
#include "core/language/primitives/unicode.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/values.h"
#include "core/language/values/work.h"

namespace race::language::library {
namespace {

// Whether the text is not empty and every code point is of a kind.
template <typename Test>
Value every(Context& context, const Value& self, Test test) {
  if (!context.charge(work::characters(self.as_string().size()))) return Value::unknown();
  const std::u32string points = utf8::decode(self.as_string());
  for (const char32_t point : points)
    if (!test(point)) return Value(false);
  return Value(!points.empty());
}

// A sigma at the end of a word has a form of its own.
bool is_final_sigma(std::u32string_view points, std::size_t at) {
  std::size_t before = at;
  while (before > 0 && unicode::is_case_ignorable(points[before - 1])) --before;
  if (before == 0 || !unicode::is_cased(points[before - 1])) return false;
  std::size_t after = at + 1;
  while (after < points.size() && unicode::is_case_ignorable(points[after])) ++after;
  return after == points.size() || !unicode::is_cased(points[after]);
}

void append_lower(std::u32string_view points, std::size_t at, std::u32string& out) {
  constexpr char32_t kSigma = 0x3A3;
  if (points[at] == kSigma) {
    out += is_final_sigma(points, at) ? char32_t{0x3C2} : char32_t{0x3C3};
  } else {
    unicode::append_lower(points[at], out);
  }
}

// Times that a character is looked at to map its case.
constexpr std::uint64_t kMapping = 2;

template <typename Append>
Value mapped(Context& context, const Value& self, std::uint64_t per_byte, Append append) {
  if (!context.charge(per_byte * work::characters(self.as_string().size()))) return Value::unknown();
  const std::u32string points = utf8::decode(self.as_string());
  std::u32string out;
  for (std::size_t i = 0; i < points.size(); ++i) append(points, i, out);
  return within_limits(context, Value(utf8::encode(out)));
}

}  // namespace

Value str_isalnum(Context& context, const Value& self, Arguments) {
  return every(context, self, [](char32_t p) {
    return unicode::is_alpha(p) || unicode::is_decimal(p) || unicode::is_digit(p) || unicode::is_numeric(p);
  });
}
Value str_isalpha(Context& context, const Value& self, Arguments) { return every(context, self, unicode::is_alpha); }
Value str_isdigit(Context& context, const Value& self, Arguments) { return every(context, self, unicode::is_digit); }
Value str_isspace(Context& context, const Value& self, Arguments) { return every(context, self, unicode::is_space); }

Value str_islower(Context& context, const Value& self, Arguments) {
  if (!context.charge(work::characters(self.as_string().size()))) return Value::unknown();
  bool found = false;
  for (const char32_t point : utf8::decode(self.as_string())) {
    if (unicode::is_upper(point) || unicode::is_title(point)) return Value(false);
    found = found || unicode::is_lower(point);
  }
  return Value(found);
}

Value str_isupper(Context& context, const Value& self, Arguments) {
  if (!context.charge(work::characters(self.as_string().size()))) return Value::unknown();
  bool found = false;
  for (const char32_t point : utf8::decode(self.as_string())) {
    if (unicode::is_lower(point) || unicode::is_title(point)) return Value(false);
    found = found || unicode::is_upper(point);
  }
  return Value(found);
}

Value str_lower(Context& context, const Value& self, Arguments) {
  return mapped(context, self, kMapping, append_lower);
}

Value str_upper(Context& context, const Value& self, Arguments) {
  return mapped(context, self, kMapping, [](std::u32string_view points, std::size_t i, std::u32string& out) {
    unicode::append_upper(points[i], out);
  });
}

Value str_capitalize(Context& context, const Value& self, Arguments) {
  return mapped(context, self, kMapping, [](std::u32string_view points, std::size_t i, std::u32string& out) {
    if (i == 0) {
      unicode::append_title(points[i], out);
    } else {
      append_lower(points, i, out);
    }
  });
}

Value str_title(Context& context, const Value& self, Arguments) {
  return mapped(context, self, 3 * kMapping, [](std::u32string_view points, std::size_t i, std::u32string& out) {
    if (i > 0 && unicode::is_cased(points[i - 1])) {
      append_lower(points, i, out);
    } else {
      unicode::append_title(points[i], out);
    }
  });
}

Value str_swapcase(Context& context, const Value& self, Arguments) {
  return mapped(context, self, kMapping, [](std::u32string_view points, std::size_t i, std::u32string& out) {
    if (unicode::is_upper(points[i])) {
      append_lower(points, i, out);
    } else if (unicode::is_lower(points[i])) {
      unicode::append_upper(points[i], out);
    } else {
      out += points[i];
    }
  });
}

}  // namespace race::language::library
