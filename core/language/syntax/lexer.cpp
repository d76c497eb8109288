#include "core/language/syntax/lexer.h"

#include <algorithm>
#include <array>
#include <string>

namespace race::language {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_hex(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

class Lexer {
 public:
  Lexer(std::string_view source, Span span, Layout layout, std::vector<Problem>& problems)
      : source_(source.substr(0, span.end)), at_(span.begin), layout_(layout), problems_(problems) {}

  std::vector<Token> run() {
    tokens_.reserve((source_.size() - std::min(at_, source_.size())) / kBytesOfToken + 4);
    bool line_begins = layout_ == Layout::lines;
    while (!failed_) {
      if (line_begins && !indentation()) break;
      line_begins = false;
      skip_space();
      if (failed_ || at_ >= source_.size()) break;
      if (peek() == '\n') {
        const bool ends = layout_ == Layout::lines && brackets_.empty();
        if (ends && !tokens_.empty() && tokens_.back().kind != TokenKind::newline) put(TokenKind::newline, at_, at_);
        ++at_;
        line_begins = ends;
        continue;
      }
      token();
    }
    finish();
    return std::move(tokens_);
  }

 private:
  static constexpr std::size_t kBytesOfToken = 3;  // about, with the space before it

  char peek(std::size_t ahead = 0) const { return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0'; }
  void put(TokenKind kind, std::size_t begin, std::size_t end) {
    const Span span{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    tokens_.push_back({kind, span, slice(source_, span)});
  }
  void fail(ErrorCode code, std::string message, std::size_t begin) {
    if (failed_) return;
    failed_ = true;
    const auto end = static_cast<std::uint32_t>(std::min(begin + 1, source_.size()));
    problems_.push_back({code, std::move(message), {static_cast<std::uint32_t>(begin), end}});
  }

  // Reads the space at the beginning of a line; false at the end of the text. Blank and comment lines have no indent.
  bool indentation() {
    std::size_t column = 0;
    std::size_t in_ones = 0;  // the width if a tab were one space: both must agree (as in Python)
    for (;; ++at_) {
      if (peek() == ' ') {
        ++column;
        ++in_ones;
      } else if (peek() == '\t') {
        column = (column / 8 + 1) * 8;
        ++in_ones;
      } else if (peek() == '\f') {
        column = in_ones = 0;
      } else {
        break;
      }
    }
    if (at_ >= source_.size()) return false;
    if (peek() == '\n' || peek() == '#' || (peek() == '\r' && peek(1) == '\n')) return true;
    return indent_to(column, in_ones);
  }

  bool indent_to(std::size_t column, std::size_t in_ones) {
    const auto [last, last_ones] = indents_.back();
    if ((column > last) != (in_ones > last_ones) || (column == last) != (in_ones == last_ones))
      return fail(ErrorCode::syntax, "inconsistent use of tabs and spaces in indentation", at_), false;
    if (column > last) {
      if (indents_.size() > 100) return fail(ErrorCode::syntax, "too many levels of indentation", at_), false;
      indents_.emplace_back(column, in_ones);
      put(TokenKind::indent, at_, at_);
    }
    while (column < indents_.back().first) {
      indents_.pop_back();
      put(TokenKind::dedent, at_, at_);
    }
    if (column != indents_.back().first)
      return fail(ErrorCode::syntax, "unindent does not match any outer indentation level", at_), false;
    return true;
  }

  void skip_space() {
    for (;;) {
      if (peek() == ' ' || peek() == '\t' || peek() == '\f') {
        ++at_;
      } else if (peek() == '\r' && (peek(1) == '\n' || at_ + 1 == source_.size())) {
        ++at_;
      } else if (peek() == '\\' && (peek(1) == '\n' || (peek(1) == '\r' && peek(2) == '\n'))) {
        at_ += peek(1) == '\n' ? 2 : 3;
        if (at_ >= source_.size()) return fail(ErrorCode::syntax, "the text ends after a backslash", at_ - 1);
      } else if (peek() == '#' && layout_ == Layout::lines) {
        while (at_ < source_.size() && peek() != '\n') ++at_;
      } else {
        return;
      }
    }
  }

  void token() {
    if (is_letter(peek())) {
      name_or_string();
    } else if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) {
      number();
    } else if (peek() == '\'' || peek() == '"') {
      string(at_);
    } else {
      operator_token();
    }
  }

  void name_or_string() {
    const std::size_t begin = at_;
    while (is_letter(peek()) || is_digit(peek())) ++at_;
    if ((peek() == '\'' || peek() == '"') && at_ - begin <= 2 && is_prefix(source_.substr(begin, at_ - begin)))
      return string(begin);
    if (static_cast<unsigned char>(peek()) >= 0x80)
      return fail(ErrorCode::forbidden, "names have the letters a-z, A-Z, digits and _", at_);
    put(is_keyword(source_.substr(begin, at_ - begin)) ? TokenKind::keyword : TokenKind::name, begin, at_);
  }

  static bool is_prefix(std::string_view text) {
    std::string lower;
    for (const char c : text) lower += static_cast<char>(c | 0x20);
    static constexpr std::array kPrefixes = {"r", "u", "f", "b", "fr", "rf", "br", "rb"};
    return std::find(kPrefixes.begin(), kPrefixes.end(), lower) != kPrefixes.end();
  }

  // at_ is the position of the opening quote, `begin` that of the prefix.
  void string(std::size_t begin) {
    const char quote = peek();
    const bool triple = peek(1) == quote && peek(2) == quote;
    at_ += triple ? 3 : 1;
    for (;;) {
      if (at_ >= source_.size() || (!triple && peek() == '\n'))
        return fail(ErrorCode::syntax, "unterminated string literal", begin);
      if (peek() == '\\') {
        at_ += at_ + 1 < source_.size() ? 2 : 1;
      } else if (peek() == quote && (!triple || (peek(1) == quote && peek(2) == quote))) {
        at_ += triple ? 3 : 1;
        return put(TokenKind::string, begin, at_);
      } else {
        ++at_;
      }
    }
  }

  // digits with single underscores between them
  template <typename Digit>
  bool digits(Digit is) {
    if (!is(peek())) return false;
    for (;;) {
      while (is(peek())) ++at_;
      if (peek() != '_') return true;
      ++at_;
      if (!is(peek())) return false;
    }
  }

  void number() {
    const std::size_t begin = at_;
    bool good = true;
    const char kind = static_cast<char>(peek(1) | 0x20);
    if (peek() == '0' && (kind == 'x' || kind == 'o' || kind == 'b')) {
      at_ += peek(2) == '_' ? 3 : 2;
      good = kind == 'x'   ? digits(is_hex)
             : kind == 'o' ? digits([](char c) { return c >= '0' && c <= '7'; })
                           : digits([](char c) { return c == '0' || c == '1'; });
    } else {
      good = decimal(begin);
    }
    if (good && (peek() == 'j' || peek() == 'J')) return fail(ErrorCode::forbidden, "complex numbers", begin);
    if (!good || is_letter(peek()) || is_digit(peek())) return fail(ErrorCode::syntax, "invalid number", begin);
    put(TokenKind::number, begin, at_);
  }

  bool decimal(std::size_t begin) {
    bool floating = false;
    if (peek() != '.' && !digits(is_digit)) return false;
    const std::string_view whole = source_.substr(begin, at_ - begin);
    if (peek() == '.') {
      floating = true;
      ++at_;
      if (is_digit(peek()) && !digits(is_digit)) return false;
    }
    if (peek() == 'e' || peek() == 'E') {
      const bool sign = peek(1) == '+' || peek(1) == '-';
      if (!is_digit(peek(sign ? 2 : 1))) return false;
      floating = true;
      at_ += sign ? 2 : 1;
      if (!digits(is_digit)) return false;
    }
    const bool leading_zero = whole.size() > 1 && whole[0] == '0' && whole.find_first_not_of("0_") != whole.npos;
    return floating || !leading_zero;
  }

  void operator_token() {
    const std::size_t size = operator_size(source_.substr(at_, 3));
    if (size == 0) {
      if (static_cast<unsigned char>(peek()) >= 0x80)
        return fail(ErrorCode::forbidden, "names have the letters a-z, A-Z, digits and _", at_);
      return fail(ErrorCode::syntax, "unexpected character", at_);
    }
    if (!bracket(peek())) return;
    put(TokenKind::op, at_, at_ + size);
    at_ += size;
  }

  // Of the longest operator with which `text` begins; 0: none.
  static std::size_t operator_size(std::string_view text) {
    static constexpr std::array<std::string_view, 5> kThree = {"**=", "//=", ">>=", "<<=", "..."};
    static constexpr std::array<std::string_view, 19> kTwo = {"==", "!=", "<=", ">=", "+=", "-=", "*=",
                                                              "/=", "%=", "&=", "|=", "^=", "@=", "**",
                                                              "//", "<<", ">>", "->", ":="};
    static constexpr std::string_view kOne = "+-*/%&|^~<>=()[]{},:.;@";
    const auto is_punctuation = [](char c) { return kOne.find(c) != kOne.npos || c == '!'; };
    if (text.size() > 1 && is_punctuation(text[1])) {
      if (text.size() > 2 && std::ranges::find(kThree, text) != kThree.end()) return 3;
      if (std::ranges::find(kTwo, text.substr(0, 2)) != kTwo.end()) return 2;
    }
    return kOne.find(text[0]) == kOne.npos ? 0 : 1;
  }

  bool bracket(char c) {
    if (c == '(' || c == '[' || c == '{') {
      if (brackets_.size() >= 200) return fail(ErrorCode::syntax, "too many nested parentheses", at_), false;
      brackets_ += c;
    } else if (c == ')' || c == ']' || c == '}') {
      const char opening = c == ')' ? '(' : c == ']' ? '[' : '{';
      if (brackets_.empty() || brackets_.back() != opening)
        return fail(ErrorCode::syntax, "a closing bracket without its opening one", at_), false;
      brackets_.pop_back();
    }
    return true;
  }

  void finish() {
    if (!failed_ && !brackets_.empty()) fail(ErrorCode::syntax, "a bracket was never closed", source_.size());
    if (layout_ == Layout::lines) {
      if (!tokens_.empty() && tokens_.back().kind != TokenKind::newline && tokens_.back().kind != TokenKind::dedent)
        put(TokenKind::newline, at_, at_);
      for (; indents_.size() > 1; indents_.pop_back()) put(TokenKind::dedent, at_, at_);
    }
    put(TokenKind::end, at_, at_);
  }

  std::string_view source_;
  std::size_t at_;
  Layout layout_;
  std::vector<Problem>& problems_;
  bool failed_ = false;
  std::vector<std::pair<std::size_t, std::size_t>> indents_ = {{0, 0}};
  std::string brackets_;  // the open ones
  std::vector<Token> tokens_;
};

}  // namespace

bool is_keyword(std::string_view name) {
  static constexpr std::array<std::string_view, 35> kKeywords = {
      "False", "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
      "class", "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
      "from",  "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
      "or",    "pass",     "raise", "return", "try",  "while",  "with",   "yield"};
  constexpr std::size_t kLongest = 8;
  return name.size() > 1 && name.size() <= kLongest &&
         std::find(kKeywords.begin(), kKeywords.end(), name) != kKeywords.end();
}

std::vector<Token> lex(std::string_view source, Span span, Layout layout, std::vector<Problem>& problems) {
  return Lexer(source, span, layout, problems).run();
}

}  // namespace race::language
