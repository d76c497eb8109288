// String literals: prefixes, escapes, and the parts of f-strings (rules of Python 3.11: no backslash and no quote of
// the string's own kind inside of a replacement field).
#include <charconv>

#include "core/language/primitives/utf8.h"
#include "core/language/syntax/parser_internal.h"

namespace race::language {
namespace {

std::uint32_t at_of(std::size_t v) { return static_cast<std::uint32_t>(v); }

}  // namespace

// STRING → [prefix] ("'" ... "'" | '"' ... '"' | "'''" ... "'''" | '"""' ... '"""')
void Parser::string_literal(const Token& token, std::vector<ExprPtr>& parts) {
  const std::size_t quote = token.text.find_first_of("'\"");
  bool raw = false;
  bool formatted = false;
  for (const char c : token.text.substr(0, quote)) {
    raw = raw || c == 'r' || c == 'R';
    formatted = formatted || c == 'f' || c == 'F';
    if (c == 'b' || c == 'B') forbid("bytes", token.at);
  }
  const bool triple =
      token.text.size() >= quote + 6 && token.text.substr(quote, 3) == std::string(3, token.text[quote]);
  const std::size_t width = triple ? 3 : 1;
  const Span body{token.at.begin + at_of(quote + width), token.at.end - at_of(width)};
  if (formatted) {
    fstring_parts(body, raw, 0, parts);
  } else {
    ExprPtr e = make(ExprKind::constant, token.at.begin);
    e->value = Value(unescape(body, raw, false));
    parts.push_back(finish(std::move(e)));
  }
}

// The text of a literal; with `braces`, {{ and }} are one brace.
std::string Parser::unescape(Span body, bool raw, bool braces) {
  std::string out;
  for (std::uint32_t at = body.begin; at < body.end && !failed_;) {
    const char c = source_[at];
    if (c == '\\' && !raw) {
      at = escape(at + 1, body, out);
    } else if (c == '\r' && at + 1 < body.end && source_[at + 1] == '\n') {
      ++at;
    } else {
      out += c;
      at += braces && (c == '{' || c == '}') && at + 1 < body.end && source_[at + 1] == c ? 2 : 1;
    }
  }
  return out;
}

// escape → '\' (NEWLINE | one of \ ' " a b f n r t v | 1 to 3 octal digits | 'x' HH | 'u' HHHH | 'U' HHHHHHHH)
// `at` is the position after the backslash; returns the position after the escape. Unknown escapes keep their
// backslash.
std::uint32_t Parser::escape(std::uint32_t at, Span body, std::string& out) {
  static constexpr std::string_view kLetters = "\\'\"abfnrtv";
  static constexpr std::string_view kMeanings = "\\'\"\a\b\f\n\r\t\v";
  const char c = source_[at];
  if (c == '\n') return at + 1;
  if (c == '\r' && at + 1 < body.end && source_[at + 1] == '\n') return at + 2;
  if (const std::size_t i = kLetters.find(c); i != std::string_view::npos) {
    out += kMeanings[i];
    return at + 1;
  }
  if (c == 'N') forbid("\\N{...}", {at - 1, at + 1});
  std::uint32_t point = 0;
  std::uint32_t end = at;
  if (c >= '0' && c <= '7') {
    for (; end < body.end && end < at + 3 && source_[end] >= '0' && source_[end] <= '7'; ++end)
      point = point * 8 + static_cast<std::uint32_t>(source_[end] - '0');
  } else if (c == 'x' || c == 'u' || c == 'U') {
    const std::uint32_t digits = c == 'x' ? 2 : c == 'u' ? 4 : 8;
    end = at + 1 + digits;
    const char* first = source_.data() + at + 1;
    if (end > body.end || std::from_chars(first, first + digits, point, 16).ptr != first + digits || point > 0x10FFFF) {
      fail("an escape needs its hexadecimal digits", {at - 1, at + 1});
      return body.end;
    }
    if (point >= 0xD800 && point <= 0xDFFF) forbid("surrogates", {at - 1, end});
  } else {
    out += '\\';
    return at;
  }
  utf8::append(point, out);
  return end;
}

// fstring → (text | replacement_field)*        at level 1, a format, ended by '}'. Returns where it ended.
std::uint32_t Parser::fstring_parts(Span body, bool raw, int level, std::vector<ExprPtr>& parts) {
  std::uint32_t begin = body.begin;
  std::uint32_t at = begin;
  const auto text = [&] {
    if (at == begin) return;
    ExprPtr e = make(ExprKind::constant, begin);
    e->value = Value(unescape({begin, at}, raw, level == 0));
    parts.push_back(finish(std::move(e)));
  };
  while (at < body.end && !failed_) {
    const char c = source_[at];
    const bool doubled = level == 0 && at + 1 < body.end && source_[at + 1] == c;
    if (c == '\\' && !raw && at + 1 < body.end && source_[at + 1] != '{' && source_[at + 1] != '}') {
      at += 2;
    } else if ((c == '{' || c == '}') && doubled) {
      at += 2;
    } else if (c == '{') {
      text();
      begin = at = replacement_field({at, body.end}, raw, level, parts);
    } else if (c == '}' && level > 0) {
      break;
    } else if (c == '}') {
      fail("a single '}' in an f-string", {at, at + 1});
    } else {
      ++at;
    }
  }
  if (!failed_) text();
  return at;
}

// replacement_field → '{' field_input ['='] ['!' ('r' | 's' | 'a')] [':' fstring] '}'        returns where it ended
std::uint32_t Parser::replacement_field(Span body, bool raw, int level, std::vector<ExprPtr>& parts) {
  const std::uint32_t begin = body.begin + 1;
  if (level > 1) fail("f-string: nested too deeply", body);
  std::uint32_t at = field_end({begin, body.end});
  if (failed_) return body.end;
  ExprPtr e = make(ExprKind::format, body.begin);
  const std::size_t known = problems_.size();
  e->items.push_back(Parser(source_, {begin, at}, Layout::none, nesting_ + 1, problems_).field_input());
  for (std::size_t i = known; i < problems_.size(); ++i)
    if (problems_[i].code == ErrorCode::syntax) failed_ = true, position_ = tokens_.size() - 1;
  const auto current = [&] { return at < body.end ? source_[at] : '\0'; };
  const bool shows_text = current() == '=';
  if (shows_text) {
    for (++at; current() == ' ';) ++at;
    ExprPtr text = make(ExprKind::constant, begin);
    text->value = Value(slice(source_, {begin, at}));
    parts.push_back(finish(std::move(text)));
  }
  if (current() == '!') {
    ++at;
    e->conversion = current();
    if (e->conversion != 'r' && e->conversion != 's' && e->conversion != 'a')
      fail("f-string: expected 'r', 's' or 'a' after '!'", {at - 1, at});
    ++at;
  }
  e->items.push_back(nullptr);
  if (current() == ':') {
    ExprPtr format = make(ExprKind::fstring, at);
    at = fstring_parts({at + 1, body.end}, raw, level + 1, format->items);
    e->items[1] = finish(std::move(format));
  } else if (shows_text && e->conversion == 0) {
    e->conversion = 'r';
  }
  if (current() != '}') fail("f-string: expected '}'", {body.begin, at});
  parts.push_back(finish(std::move(e)));
  return at + 1;
}

// Where the expression of a replacement field ends: at '}', ':', '!' or a '=' that is no comparison, outside of
// brackets and strings.
std::uint32_t Parser::field_end(Span body) {
  int brackets = 0;
  char quote = 0;
  for (std::uint32_t at = body.begin; at < body.end; ++at) {
    const char c = source_[at];
    const char following = at + 1 < body.end ? source_[at + 1] : '\0';
    if (c == '\\' || c == '#') {
      fail("f-string: a backslash or comment in an expression", {at, at + 1});
      return body.end;
    }
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '(' || c == '[' || c == '{') {
      ++brackets;
    } else if (brackets > 0) {
      if (c == ')' || c == ']' || c == '}') --brackets;
    } else if ((c == '!' || c == '=' || c == '<' || c == '>') && following == '=') {
      ++at;
    } else if (c == '}' || c == ':' || c == '!' || c == '=') {
      return at;
    }
  }
  fail("f-string: expected '}'", body);
  return body.end;
}

}  // namespace race::language
