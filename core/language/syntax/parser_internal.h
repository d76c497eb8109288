// The parser's class; its expressions are in parse_expressions.cpp, its statements in parse_statements.cpp.
//
// After a syntax error the parser moves to the end of its tokens, where every loop ends, and returns what it has: no
// function needs to check for errors. After a forbidden construct it continues, to find the others.
#pragma once

#include <algorithm>

#include "core/language/syntax/parser.h"

namespace race::language {

class Parser {
 public:
  Parser(std::string_view source, Span span, Layout layout, int nesting, std::vector<Problem>& problems);

  ExprPtr eval_input();
  Block file_input();
  /// The expression of a replacement field of an f-string; see string_literal.cpp. Stops before `=`, `!`, `:` or the
  /// end.
  ExprPtr field_input();

 private:
  // statements
  void statement(Block& block);
  void simple_statements(Block& block);
  Stmt simple_statement();
  Stmt expression_statement();
  Stmt augmented_assignment(ExprPtr target, BinaryOperator op, std::size_t begin);
  Stmt assignment(ExprPtr first, std::size_t begin);
  Stmt if_statement();
  Stmt while_statement();
  Stmt for_statement();
  Block block();
  void no_else_of_loop();
  bool forbidden_statement();
  void skip_statement();
  void check_target(const Expr& target);

  // expressions, weakest first
  ExprPtr expression_list();
  ExprPtr expression();
  ExprPtr disjunction();
  ExprPtr conjunction();
  ExprPtr inversion();
  ExprPtr comparison();
  bool comparison_operator(std::vector<BinaryOperator>& operators);
  ExprPtr bitwise();
  ExprPtr sum();
  ExprPtr term();
  ExprPtr factor();
  ExprPtr power();
  ExprPtr primary();
  ExprPtr atom();
  ExprPtr call(ExprPtr callee);
  void argument(Expr& call);
  ExprPtr subscript(ExprPtr object);
  ExprPtr group();
  ExprPtr list();
  ExprPtr dict_or_set();
  ExprPtr lambda();
  ExprPtr starred();
  ExprPtr number();
  ExprPtr strings();
  ExprPtr target_list();
  ExprPtr star_target();
  void comprehension_clauses(Expr& comprehension);

  // string_literal.cpp
  void string_literal(const Token& token, std::vector<ExprPtr>& parts);
  std::string unescape(Span body, bool raw, bool braces);
  std::uint32_t escape(std::uint32_t at, Span body, std::string& out);
  std::uint32_t fstring_parts(Span body, bool raw, int level, std::vector<ExprPtr>& parts);
  std::uint32_t replacement_field(Span body, bool raw, int level, std::vector<ExprPtr>& parts);
  std::uint32_t field_end(Span body);

  // tokens; position_ is always that of one of them
  const Token& peek() const { return tokens_[position_]; }
  const Token& peek(std::size_t ahead) const { return tokens_[std::min(position_ + ahead, tokens_.size() - 1)]; }
  const Token& take() {
    const Token& token = peek();
    if (position_ + 1 < tokens_.size()) ++position_;
    return token;
  }
  /// Whether an operator or keyword is next.
  bool at(std::string_view text) const {
    const Token& token = peek();
    return (token.kind == TokenKind::op || token.kind == TokenKind::keyword) && token.text == text;
  }
  bool accept(std::string_view text) {
    if (!at(text)) return false;
    take();
    return true;
  }
  void expect(std::string_view text);
  bool begins_expression() const;
  bool at_kind(TokenKind kind) const { return peek().kind == kind; }
  std::uint32_t last_end() const { return position_ == 0 ? peek().at.begin : tokens_[position_ - 1].at.end; }

  void fail(std::string message);
  void fail(std::string message, Span at);
  void forbid(std::string message, Span at);
  Span since(std::size_t begin) const { return {static_cast<std::uint32_t>(begin), last_end()}; }

  ExprPtr make(ExprKind kind, std::size_t begin);
  ExprPtr finish(ExprPtr e);  // sets its end and depth
  ExprPtr nothing();          // a placeholder where there is no expression

  /// Counts how deep the recursion is; too deep is a syntax error.
  class Nested {
   public:
    explicit Nested(Parser& parser) : parser_(parser) {
      if (++parser_.nesting_ > kMaxNesting) parser_.fail("nested too deeply");
    }
    ~Nested() { --parser_.nesting_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

   private:
    Parser& parser_;
  };

  std::string_view source_;
  std::vector<Problem>& problems_;
  std::vector<Token> tokens_;
  std::size_t position_ = 0;
  int nesting_ = 0;
  int loops_ = 0;
  bool failed_ = false;
};

}  // namespace race::language
