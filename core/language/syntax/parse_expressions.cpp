// Expressions: each function under its production. A production of Python that the function language does not have is
// parsed too, and reported as `forbidden`.
#include <array>

#include "core/language/syntax/parser_internal.h"

namespace race::language {
namespace {

constexpr std::uint64_t kIntegerLimit = std::uint64_t{1} << 63;

}  // namespace

// eval_input → expression_list NEWLINE* END
ExprPtr Parser::eval_input() {
  ExprPtr e = expression_list();
  if (e->kind == ExprKind::tuple) forbid("tuples", e->at);
  while (at_kind(TokenKind::newline)) take();
  if (!at_kind(TokenKind::end)) fail("expected the end of the expression");
  return e;
}

// field_input → expression_list ['='] END
ExprPtr Parser::field_input() {
  if (!begins_expression()) fail("expected an expression in the f-string");
  ExprPtr e = expression_list();
  if (e->kind == ExprKind::tuple) forbid("tuples", e->at);
  if (!at_kind(TokenKind::end)) fail("expected '}' in the f-string");
  return e;
}

// expression_list → expression (',' expression)* [',']        more than one: a tuple
ExprPtr Parser::expression_list() {
  const std::size_t begin = peek().at.begin;
  ExprPtr first = at("*") ? starred() : expression();
  if (!at(",")) return first;
  ExprPtr tuple = make(ExprKind::tuple, begin);
  tuple->items.push_back(std::move(first));
  while (accept(",") && begins_expression()) tuple->items.push_back(at("*") ? starred() : expression());
  return finish(std::move(tuple));
}

// expression → disjunction ['if' disjunction 'else' expression] | lambda
ExprPtr Parser::expression() {
  const Nested nested(*this);
  if (at("lambda")) return lambda();
  if (at("yield") || at("await")) {
    forbid("'" + std::string(peek().text) + "'", peek().at);
    take();
    return begins_expression() ? expression() : nothing();
  }
  const std::size_t begin = peek().at.begin;
  ExprPtr value = disjunction();
  if (at(":=")) {
    forbid("':='", take().at);
    return expression();
  }
  if (!accept("if")) return value;
  ExprPtr e = make(ExprKind::conditional, begin);
  e->items.push_back(disjunction());
  e->items.push_back(std::move(value));
  expect("else");
  e->items.push_back(expression());
  return finish(std::move(e));
}

// disjunction → conjunction ('or' conjunction)*
ExprPtr Parser::disjunction() {
  const std::size_t begin = peek().at.begin;
  ExprPtr first = conjunction();
  if (!at("or")) return first;
  ExprPtr e = make(ExprKind::logical, begin);
  e->op = BinaryOperator::logical_or;
  e->items.push_back(std::move(first));
  while (accept("or")) e->items.push_back(conjunction());
  return finish(std::move(e));
}

// conjunction → inversion ('and' inversion)*
ExprPtr Parser::conjunction() {
  const std::size_t begin = peek().at.begin;
  ExprPtr first = inversion();
  if (!at("and")) return first;
  ExprPtr e = make(ExprKind::logical, begin);
  e->op = BinaryOperator::logical_and;
  e->items.push_back(std::move(first));
  while (accept("and")) e->items.push_back(inversion());
  return finish(std::move(e));
}

// inversion → 'not' inversion | comparison
ExprPtr Parser::inversion() {
  if (!at("not")) return comparison();
  const Nested nested(*this);
  ExprPtr e = make(ExprKind::unary, take().at.begin);
  e->unary_op = UnaryOperator::logical_not;
  e->items.push_back(inversion());
  return finish(std::move(e));
}

// comparison → bitwise (comparison_operator bitwise)*
ExprPtr Parser::comparison() {
  const std::size_t begin = peek().at.begin;
  ExprPtr first = bitwise();
  std::vector<BinaryOperator> operators;
  if (!comparison_operator(operators)) return first;
  ExprPtr e = make(ExprKind::compare, begin);
  e->items.push_back(std::move(first));
  do {
    const bool identity =
        operators.back() == BinaryOperator::is_none || operators.back() == BinaryOperator::is_not_none;
    ExprPtr right = bitwise();
    if (identity && (right->kind != ExprKind::constant || !right->value.is_null()))
      forbid("'is' with other than None", right->at);
    e->items.push_back(std::move(right));
  } while (comparison_operator(operators));
  e->operators = std::move(operators);
  return finish(std::move(e));
}

// comparison_operator → '<' | '<=' | '>' | '>=' | '==' | '!=' | 'in' | 'not' 'in' | 'is' | 'is' 'not'
bool Parser::comparison_operator(std::vector<BinaryOperator>& operators) {
  static constexpr std::array<std::pair<std::string_view, BinaryOperator>, 7> kSimple = {
      {{"<", BinaryOperator::less},
       {"<=", BinaryOperator::less_equal},
       {">", BinaryOperator::greater},
       {">=", BinaryOperator::greater_equal},
       {"==", BinaryOperator::equal},
       {"!=", BinaryOperator::not_equal},
       {"in", BinaryOperator::in}}};
  for (const auto& [text, op] : kSimple)
    if (accept(text)) return operators.push_back(op), true;
  if (at("not") && peek(1).kind == TokenKind::keyword && peek(1).text == "in") {
    take();
    take();
    return operators.push_back(BinaryOperator::not_in), true;
  }
  if (accept("is"))
    return operators.push_back(accept("not") ? BinaryOperator::is_not_none : BinaryOperator::is_none), true;
  return false;
}

// bitwise → sum (('|' | '^' | '&' | '<<' | '>>') sum)*        not in the language
ExprPtr Parser::bitwise() {
  ExprPtr e = sum();
  while (at("|") || at("^") || at("&") || at("<<") || at(">>")) {
    forbid("operator '" + std::string(peek().text) + "'", peek().at);
    take();
    e = sum();
  }
  return e;
}

// sum → term (('+' | '-') term)*
ExprPtr Parser::sum() {
  const std::size_t begin = peek().at.begin;
  ExprPtr left = term();
  while (at("+") || at("-")) {
    ExprPtr e = make(ExprKind::binary, begin);
    e->op = take().text == "+" ? BinaryOperator::add : BinaryOperator::subtract;
    e->items.push_back(std::move(left));
    e->items.push_back(term());
    left = finish(std::move(e));
  }
  return left;
}

// term → factor (('*' | '/' | '//' | '%') factor)*        also '@', which is not in the language
ExprPtr Parser::term() {
  const std::size_t begin = peek().at.begin;
  ExprPtr left = factor();
  while (at("*") || at("/") || at("//") || at("%") || at("@")) {
    const Token op = take();
    if (op.text == "@") forbid("operator '@'", op.at);
    ExprPtr e = make(ExprKind::binary, begin);
    e->op = op.text == "*"    ? BinaryOperator::multiply
            : op.text == "/"  ? BinaryOperator::divide
            : op.text == "//" ? BinaryOperator::floor_divide
                              : BinaryOperator::modulo;
    const bool text = left->kind == ExprKind::fstring || (left->kind == ExprKind::constant && left->value.is_string());
    if (e->op == BinaryOperator::modulo && text) forbid("formatting a string with '%'", op.at);
    e->items.push_back(std::move(left));
    e->items.push_back(factor());
    left = finish(std::move(e));
  }
  return left;
}

// factor → ('+' | '-') factor | power        also '~', which is not in the language
ExprPtr Parser::factor() {
  if (!at("+") && !at("-") && !at("~")) return power();
  const Nested nested(*this);
  const Token op = take();
  if (op.text == "~") forbid("operator '~'", op.at);
  if (op.text == "-" && at_kind(TokenKind::number) && peek(1).text != "**" && peek(1).text != "." &&
      peek(1).text != "[") {
    // The one integer whose absolute value is none.
    std::string digits;
    for (const char c : peek().text)
      if (c != '_') digits += c;
    if (digits == std::to_string(kIntegerLimit)) {
      take();
      ExprPtr e = make(ExprKind::constant, op.at.begin);
      e->value = Value(INT64_MIN);
      return finish(std::move(e));
    }
  }
  ExprPtr e = make(ExprKind::unary, op.at.begin);
  e->unary_op = op.text == "-" ? UnaryOperator::negative : UnaryOperator::positive;
  e->items.push_back(factor());
  return finish(std::move(e));
}

// power → primary ['**' factor]
ExprPtr Parser::power() {
  const std::size_t begin = peek().at.begin;
  ExprPtr base = primary();
  if (!accept("**")) return base;
  ExprPtr e = make(ExprKind::binary, begin);
  e->op = BinaryOperator::power;
  e->items.push_back(std::move(base));
  e->items.push_back(factor());
  return finish(std::move(e));
}

}  // namespace race::language
