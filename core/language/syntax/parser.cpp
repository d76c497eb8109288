// The parser's entry points and its handling of tokens and problems.
#include "core/language/syntax/parser.h"

#include <algorithm>

#include "core/language/primitives/utf8.h"
#include "core/language/syntax/parser_internal.h"

namespace race::language {

Parser::Parser(std::string_view source, Span span, Layout layout, int nesting, std::vector<Problem>& problems)
    : source_(source), problems_(problems), nesting_(nesting) {
  const std::size_t before = problems.size();
  tokens_ = lex(source, span, layout, problems);
  if (problems.size() > before) {
    // What cannot be split into tokens is not parsed.
    failed_ = true;
    position_ = tokens_.size() - 1;
  }
}

void Parser::expect(std::string_view text) {
  if (!accept(text)) fail("expected '" + std::string(text) + "'");
}

// Whether an expression can begin at the next token.
bool Parser::begins_expression() const {
  const Token& token = peek();
  if (token.kind == TokenKind::keyword)
    return token.text == "not" || token.text == "lambda" || token.text == "None" || token.text == "True" ||
           token.text == "False" || token.text == "await" || token.text == "yield";
  if (token.kind == TokenKind::op)
    return token.text == "(" || token.text == "[" || token.text == "{" || token.text == "-" || token.text == "+" ||
           token.text == "~" || token.text == "*" || token.text == "...";
  return token.kind == TokenKind::name || token.kind == TokenKind::number || token.kind == TokenKind::string;
}

void Parser::fail(std::string message) { fail(std::move(message), peek().at); }

void Parser::fail(std::string message, Span at) {
  if (!failed_) problems_.push_back({ErrorCode::syntax, std::move(message), at});
  failed_ = true;
  position_ = tokens_.size() - 1;
}

void Parser::forbid(std::string message, Span at) {
  if (!failed_) problems_.push_back({ErrorCode::forbidden, std::move(message), at});
}

ExprPtr Parser::make(ExprKind kind, std::size_t begin) {
  auto e = std::make_unique<Expr>();
  e->kind = kind;
  e->at.begin = static_cast<std::uint32_t>(begin);
  return e;
}

ExprPtr Parser::finish(ExprPtr e) {
  e->at.end = std::max(last_end(), e->at.begin);
  for_each_part(*e,
                [&](const Expr& part) { e->depth = std::max(e->depth, static_cast<std::uint16_t>(part.depth + 1)); });
  if (e->depth > kMaxTreeDepth) fail("the expression has too many levels", e->at);
  return e;
}

ExprPtr Parser::nothing() { return finish(make(ExprKind::constant, peek().at.begin)); }

Parsed parse(std::string_view text, CodeKind kind) {
  Parsed parsed;
  if (!utf8::valid(text) || text.find('\0') != std::string_view::npos) {
    parsed.problems.push_back({ErrorCode::syntax, "the text is not UTF-8 or has a null character", {}});
    return parsed;
  }
  if (text.size() > kMaxBytes) {
    parsed.problems.push_back(
        {ErrorCode::syntax, "the text has more than " + std::to_string(kMaxBytes) + " bytes", {}});
    return parsed;
  }
  if (kind != CodeKind::function) {
    // As Python's eval, which ignores space before an expression.
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    const Span span{static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(text.size())};
    parsed.tree.expression = Parser(text, span, Layout::lines, 0, parsed.problems).eval_input();
  } else {
    const Span span{0, static_cast<std::uint32_t>(text.size())};
    parsed.tree.statements = Parser(text, span, Layout::lines, 0, parsed.problems).file_input();
  }
  return parsed;
}

}  // namespace race::language
