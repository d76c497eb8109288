// Statements: each function under its production.
#include <algorithm>
#include <array>

#include "core/language/syntax/parser_internal.h"

namespace race::language {

// file_input → statement* END
Block Parser::file_input() {
  Block block;
  while (!at_kind(TokenKind::end)) statement(block);
  return block;
}

// statement → if_statement | while_statement | for_statement | simple_statements
void Parser::statement(Block& block) {
  const Nested nested(*this);
  if (at_kind(TokenKind::indent)) return fail("unexpected indent");
  if (forbidden_statement()) return;
  if (at("if")) {
    block.push_back(if_statement());
  } else if (at("while")) {
    block.push_back(while_statement());
  } else if (at("for")) {
    block.push_back(for_statement());
  } else {
    simple_statements(block);
  }
}

// simple_statements → simple_statement (';' simple_statement)* [';'] NEWLINE
void Parser::simple_statements(Block& block) {
  block.push_back(simple_statement());
  while (accept(";") && !at_kind(TokenKind::newline)) block.push_back(simple_statement());
  if (!at_kind(TokenKind::newline)) return fail("expected the end of the statement");
  take();
}

// simple_statement → 'pass' | 'break' | 'continue' | expression_statement
Stmt Parser::simple_statement() {
  Stmt s;
  s.at = peek().at;
  if (at("pass") || at("break") || at("continue")) {
    const Token word = take();
    if (word.text != "pass" && loops_ == 0) fail("'" + std::string(word.text) + "' outside loop", word.at);
    s.kind = word.text == "pass"    ? StmtKind::pass
             : word.text == "break" ? StmtKind::break_loop
                                    : StmtKind::continue_loop;
    return s;
  }
  if (forbidden_statement()) {
    // The rest of the line was skipped; the token that ended it is read again.
    if (position_ > 0 && !failed_) --position_;
    return s;
  }
  return expression_statement();
}

// expression_statement → expression_list | assignment | augmented_assignment
Stmt Parser::expression_statement() {
  static constexpr std::array<std::pair<std::string_view, BinaryOperator>, 7> kAugmented = {
      {{"+=", BinaryOperator::add},
       {"-=", BinaryOperator::subtract},
       {"*=", BinaryOperator::multiply},
       {"/=", BinaryOperator::divide},
       {"//=", BinaryOperator::floor_divide},
       {"%=", BinaryOperator::modulo},
       {"**=", BinaryOperator::power}}};
  const std::size_t begin = peek().at.begin;
  ExprPtr first = expression_list();
  if (at("=")) return assignment(std::move(first), begin);
  for (const auto& [text, op] : kAugmented)
    if (accept(text)) return augmented_assignment(std::move(first), op, begin);
  if (at("@=") || at("&=") || at("|=") || at("^=") || at("<<=") || at(">>=")) {
    forbid("operator '" + std::string(peek().text) + "'", peek().at);
    take();
    ExprPtr ignored = expression_list();
  } else if (at(":")) {
    forbid("annotations", take().at);
    ExprPtr ignored = expression();
    if (accept("=")) ignored = expression_list();
  } else if (first->kind == ExprKind::tuple) {
    forbid("tuples", first->at);
  }
  Stmt s;
  s.kind = StmtKind::expression;
  s.value = std::move(first);
  s.at = since(begin);
  return s;
}

// assignment → (target_list '=')+ expression_list
Stmt Parser::assignment(ExprPtr first, std::size_t begin) {
  Stmt s;
  s.kind = StmtKind::assign;
  s.value = std::move(first);
  while (accept("=")) {
    check_target(*s.value);
    s.targets.push_back(std::move(s.value));
    if (at("yield")) forbid("'yield'", peek().at);
    s.value = expression_list();
  }
  bool unpacks = true;
  for (const ExprPtr& target : s.targets)
    unpacks = unpacks && (target->kind == ExprKind::tuple || target->kind == ExprKind::list);
  if (s.value->kind == ExprKind::tuple && !unpacks) forbid("tuples", s.value->at);
  s.at = since(begin);
  return s;
}

// augmented_assignment → target ('+=' | '-=' | '*=' | '/=' | '//=' | '%=' | '**=') expression_list
Stmt Parser::augmented_assignment(ExprPtr target, BinaryOperator op, std::size_t begin) {
  Stmt s;
  s.kind = StmtKind::augment;
  s.op = op;
  if (target->kind == ExprKind::tuple || target->kind == ExprKind::list)
    fail("a list of targets cannot be changed in place", target->at);
  check_target(*target);
  s.targets.push_back(std::move(target));
  s.value = expression_list();
  if (s.value->kind == ExprKind::tuple) forbid("tuples", s.value->at);
  s.at = since(begin);
  return s;
}

// target → NAME | primary '.' NAME | primary '[' expression ']' | '(' target_list ')' | '[' target_list ']'
void Parser::check_target(const Expr& target) {
  switch (target.kind) {
    case ExprKind::name:
    case ExprKind::attribute:
    case ExprKind::index:
      return;
    case ExprKind::slice:
      return forbid("slices as targets", target.at);
    case ExprKind::tuple:
    case ExprKind::list:
      for (const ExprPtr& item : target.items) check_target(*item);
      return;
    default:
      fail("cannot assign to this expression", target.at);
  }
}

// if_statement → 'if' expression ':' block ('elif' expression ':' block)* ['else' ':' block]
Stmt Parser::if_statement() {
  Stmt s;
  s.kind = StmtKind::branch;
  s.at = peek().at;
  do {
    take();
    s.tests.push_back(expression());
    s.blocks.push_back(block());
  } while (at("elif"));
  if (accept("else")) s.blocks.push_back(block());
  s.at.end = last_end();
  return s;
}

// while_statement → 'while' expression ':' block
Stmt Parser::while_statement() {
  Stmt s;
  s.kind = StmtKind::while_loop;
  s.at = take().at;
  s.value = expression();
  ++loops_;
  s.blocks.push_back(block());
  --loops_;
  s.at.end = last_end();
  no_else_of_loop();
  return s;
}

// for_statement → 'for' target_list 'in' expression_list ':' block
Stmt Parser::for_statement() {
  Stmt s;
  s.kind = StmtKind::for_loop;
  s.at = take().at;
  s.targets.push_back(target_list());
  check_target(*s.targets[0]);
  expect("in");
  s.value = expression_list();
  if (s.value->kind == ExprKind::tuple) forbid("tuples", s.value->at);
  ++loops_;
  s.blocks.push_back(block());
  --loops_;
  s.at.end = last_end();
  no_else_of_loop();
  return s;
}

// block → ':' NEWLINE INDENT statement+ DEDENT | ':' simple_statements
Block Parser::block() {
  Block inner;
  expect(":");
  if (!at_kind(TokenKind::newline)) {
    const bool compound = at("if") || at("while") || at("for");
    if (compound) fail("expected an indented block");
    simple_statements(inner);
    return inner;
  }
  take();
  if (!at_kind(TokenKind::indent)) {
    fail("expected an indented block");
    return inner;
  }
  take();
  while (!at_kind(TokenKind::dedent) && !at_kind(TokenKind::end)) statement(inner);
  if (at_kind(TokenKind::dedent)) take();
  return inner;
}

void Parser::no_else_of_loop() {
  if (!at("else")) return;
  forbid("'else' of a loop", take().at);
  const Block ignored = block();
}

// A statement of Python that the language does not have is reported and left out, with its block.
bool Parser::forbidden_statement() {
  static constexpr std::array<std::string_view, 15> kStatements = {"import", "from",     "def",   "class",  "try",
                                                                   "with",   "return",   "raise", "assert", "del",
                                                                   "global", "nonlocal", "async", "await",  "yield"};
  const bool decorator = peek().kind == TokenKind::op && peek().text == "@";
  const bool keyword = at_kind(TokenKind::keyword) && std::ranges::find(kStatements, peek().text) != kStatements.end();
  if (!decorator && !keyword) return false;
  forbid("'" + std::string(peek().text) + "'", peek().at);
  skip_statement();
  while (at("except") || at("finally") || (at("else") && !failed_)) skip_statement();
  return true;
}

void Parser::skip_statement() {
  while (!at_kind(TokenKind::newline) && !at_kind(TokenKind::end)) take();
  if (at_kind(TokenKind::newline)) take();
  if (!at_kind(TokenKind::indent)) return;
  int depth = 0;
  do {
    const TokenKind kind = take().kind;
    if (kind == TokenKind::indent) ++depth;
    if (kind == TokenKind::dedent) --depth;
  } while (depth > 0 && !at_kind(TokenKind::end));
}

}  // namespace race::language
