#include "core/language/values/printing.h"

#include <cstdio>

#include "core/language/primitives/numbers.h"
#include "core/language/primitives/unicode.h"
#include "core/language/primitives/utf8.h"
#include "core/language/values/work.h"

namespace race::language {
namespace {

// \xhh, \uhhhh or \Uhhhhhhhh, the shortest that holds the code point
void append_escape(char32_t point, std::string& out) {
  char buffer[12];
  const char* pattern = point < 0x100 ? "\\x%02x" : point < 0x10000 ? "\\u%04x" : "\\U%08x";
  std::snprintf(buffer, sizeof buffer, pattern, static_cast<unsigned>(point));
  out += buffer;
}

void append_quoted(std::string_view text, std::string& out) {
  const bool has_single = text.find('\'') != std::string_view::npos;
  const char quote = has_single && text.find('"') == std::string_view::npos ? '"' : '\'';
  out += quote;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const char32_t point = utf8::next(text, at);
    if (point == static_cast<char32_t>(quote) || point == '\\') {
      out += '\\';
      out += static_cast<char>(point);
    } else if (point == '\n') {
      out += "\\n";
    } else if (point == '\r') {
      out += "\\r";
    } else if (point == '\t') {
      out += "\\t";
    } else if (unicode::is_printable(point)) {
      out += text.substr(begin, at - begin);
    } else {
      append_escape(point, out);
    }
  }
  out += quote;
}

void append(const Value& v, std::string& out) {
  switch (v.kind()) {
    case Value::Kind::unknown:
    case Value::Kind::null:
      out += "None";
      return;
    case Value::Kind::boolean:
      out += v.as_bool() ? "True" : "False";
      return;
    case Value::Kind::integer:
      out += std::to_string(v.as_integer());
      return;
    case Value::Kind::number:
      out += repr(v.as_number());
      return;
    case Value::Kind::string:
      return append_quoted(v.as_string(), out);
    case Value::Kind::list: {
      out += '[';
      bool first = true;
      for (const Value& item : v.as_list()) {
        if (!first) out += ", ";
        first = false;
        append(item, out);
      }
      out += ']';
      return;
    }
    case Value::Kind::dict: {
      out += '{';
      bool first = true;
      for (const auto& [key, item] : v.as_dict()) {
        if (!first) out += ", ";
        first = false;
        append(key, out);
        out += ": ";
        append(item, out);
      }
      out += '}';
      return;
    }
  }
}

}  // namespace

std::string str(const Value& v) { return v.is_string() ? v.as_string() : repr(v); }

std::string repr(const Value& v) {
  std::string out;
  append(v, out);
  return out;
}

namespace {

std::uint64_t cost_of_printing(const Value& v) {
  if (v.is_number()) return 2 * work::made(1);
  if (v.is_string()) return work::made(1) + work::characters(v.as_string().size()) / 2;
  std::uint64_t cost = work::made(1) / 2;
  if (v.is_list())
    for (const Value& item : v.as_list()) cost += cost_of_printing(item);
  if (v.is_dict())
    for (const auto& [key, item] : v.as_dict()) cost += cost_of_printing(key) + cost_of_printing(item);
  return cost;
}

}  // namespace

bool charge_printing(Context& context, const Value& v) { return context.charge(cost_of_printing(v)); }

std::string ascii(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const char32_t point = utf8::next(text, at);
    if (point < 0x80) {
      out += static_cast<char>(point);
    } else {
      append_escape(point, out);
    }
  }
  return out;
}

}  // namespace race::language
