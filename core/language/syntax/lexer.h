// Tokens of a code text, as Python's: names, numbers, strings, operators, and the lines and indents that make blocks.
#pragma once

#include <string_view>
#include <vector>

#include "core/language/syntax/source.h"
#include "core/value/expected.h"

namespace race::language {

enum class TokenKind : std::uint8_t { name, keyword, number, string, op, newline, indent, dedent, end };

struct Token {
  TokenKind kind = TokenKind::end;
  Span at;
  std::string_view text;  // a piece of the source
};

/// A syntax error, or a construct that the language does not have.
struct Problem {
  ErrorCode code = ErrorCode::syntax;
  std::string message;
  Span at;
};

/// How lines are read: in a block they end statements and begin blocks; inside of an f-string they mean nothing.
enum class Layout : std::uint8_t { lines, none };

/// The tokens of source[span], ending with `end`. Requires valid UTF-8. On a problem `problems` gets one entry and the
/// tokens before it are returned.
std::vector<Token> lex(std::string_view source, Span span, Layout layout, std::vector<Problem>& problems);

bool is_keyword(std::string_view name);

}  // namespace race::language
