// Expressions that bind strongest: names, literals, brackets, calls, subscripts, comprehensions, targets.
#include <charconv>

#include "core/language/primitives/numbers.h"
#include "core/language/syntax/parser_internal.h"

namespace race::language {

// primary → atom ('.' NAME | '(' arguments ')' | '[' subscript ']')*
ExprPtr Parser::primary() {
  ExprPtr e = atom();
  for (;;) {
    if (accept(".")) {
      ExprPtr attribute = make(ExprKind::attribute, e->at.begin);
      if (!at_kind(TokenKind::name)) fail("expected a name after '.'");
      attribute->name = std::string(take().text);
      attribute->items.push_back(std::move(e));
      e = finish(std::move(attribute));
    } else if (at("(")) {
      e = call(std::move(e));
    } else if (at("[")) {
      e = subscript(std::move(e));
    } else {
      return e;
    }
  }
}

// call → callee '(' [argument (',' argument)* [',']] ')'
ExprPtr Parser::call(ExprPtr callee) {
  ExprPtr e = make(ExprKind::call, callee->at.begin);
  e->items.push_back(std::move(callee));
  take();
  while (!at(")") && !at_kind(TokenKind::end)) {
    argument(*e);
    if (!at(")")) expect(",");
  }
  expect(")");
  return finish(std::move(e));
}

// argument → expression | NAME '=' expression        also '*' and '**' and generators, which are not in the language
void Parser::argument(Expr& call) {
  if (at("*") || at("**")) {
    ExprPtr ignored = starred();
    return;
  }
  if (at_kind(TokenKind::name) && peek(1).kind == TokenKind::op && peek(1).text == "=") {
    const Token name = take();
    take();
    for (const std::string& other : call.keywords)
      if (other == name.text) return fail("keyword argument repeated: " + other, name.at);
    call.keywords.emplace_back(name.text);
    call.items.push_back(expression());
    return;
  }
  if (!call.keywords.empty()) fail("positional argument follows keyword argument");
  ExprPtr value = expression();
  if (at("for") || at("async")) {
    forbid("generator expressions", peek().at);
    comprehension_clauses(*make(ExprKind::comprehension, peek().at.begin));
  }
  call.items.push_back(std::move(value));
}

// subscript → object '[' (expression | [expression] ':' [expression] [':' [expression]]) ']'
ExprPtr Parser::subscript(ExprPtr object) {
  ExprPtr e = make(ExprKind::index, object->at.begin);
  e->items.push_back(std::move(object));
  take();
  if (!at(":")) e->items.push_back(expression());
  if (at(":")) {
    e->kind = ExprKind::slice;
    if (e->items.size() == 1) e->items.push_back(nullptr);
    take();
    e->items.push_back(at(":") || at("]") ? nullptr : expression());
    e->items.push_back(accept(":") && !at("]") ? expression() : nullptr);
  }
  if (at(",")) {
    forbid("tuples", peek().at);
    while (accept(",") && !at("]"))
      if (!accept(":")) ExprPtr ignored = expression();
  }
  expect("]");
  return finish(std::move(e));
}

// atom → NAME | 'None' | 'True' | 'False' | NUMBER | STRING+ | group | list | dict_or_set        also '...'
ExprPtr Parser::atom() {
  if (at_kind(TokenKind::number)) return number();
  if (at_kind(TokenKind::string)) return strings();
  if (at("(")) return group();
  if (at("[")) return list();
  if (at("{")) return dict_or_set();
  if (at("...")) {
    forbid("'...'", peek().at);
    take();
    return nothing();
  }
  ExprPtr e = make(ExprKind::constant, peek().at.begin);
  if (at_kind(TokenKind::name)) {
    e->kind = ExprKind::name;
    e->name = std::string(take().text);
  } else if (at("True") || at("False")) {
    e->value = Value(take().text == "True");
  } else if (!accept("None")) {
    fail("expected an expression");
  }
  return finish(std::move(e));
}

// group → '(' expression_list ')'        also '()', generators and 'yield', which are not in the language
ExprPtr Parser::group() {
  const std::size_t begin = take().at.begin;
  if (accept(")")) {
    forbid("tuples", since(begin));
    return nothing();
  }
  ExprPtr e = expression_list();
  if (at("for") || at("async")) {
    forbid("generator expressions", peek().at);
    comprehension_clauses(*make(ExprKind::comprehension, peek().at.begin));
  }
  expect(")");
  return e;
}

// list → '[' [expression (',' expression)* [',']] ']' | '[' expression comprehension_clauses ']'
ExprPtr Parser::list() {
  ExprPtr e = make(ExprKind::list, take().at.begin);
  while (!at("]") && !at_kind(TokenKind::end)) {
    e->items.push_back(at("*") ? starred() : expression());
    if (e->items.size() == 1 && (at("for") || at("async"))) {
      e->kind = ExprKind::comprehension;
      comprehension_clauses(*e);
      break;
    }
    if (!at("]")) expect(",");
  }
  expect("]");
  return finish(std::move(e));
}

// comprehension_clauses → ('for' target_list 'in' disjunction ('if' disjunction)*)+
void Parser::comprehension_clauses(Expr& e) {
  if (at("async")) {
    forbid("'async'", peek().at);
    take();
  }
  do {
    expect("for");
    Clause clause;
    clause.target = target_list();
    check_target(*clause.target);
    expect("in");
    clause.iterable = disjunction();
    while (accept("if")) clause.filters.push_back(disjunction());
    e.clauses.push_back(std::move(clause));
  } while (at("for"));
}

// dict_or_set → '{' [expression ':' expression (',' expression ':' expression)* [',']] '}'
//               also sets, '**' and comprehensions, which are not in the language
ExprPtr Parser::dict_or_set() {
  ExprPtr e = make(ExprKind::dict, take().at.begin);
  while (!at("}") && !at_kind(TokenKind::end)) {
    if (at("**") || at("*")) {
      ExprPtr ignored = starred();
    } else {
      ExprPtr key = expression();
      if (accept(":")) {
        e->items.push_back(std::move(key));
        e->items.push_back(expression());
      } else {
        forbid("sets", key->at);
      }
      if (at("for") || at("async")) {
        forbid("set and dict comprehensions", peek().at);
        comprehension_clauses(*make(ExprKind::comprehension, peek().at.begin));
      }
    }
    if (!at("}")) expect(",");
  }
  expect("}");
  return finish(std::move(e));
}

// lambda → 'lambda' ... ':' expression        not in the language
ExprPtr Parser::lambda() {
  forbid("lambda", take().at);
  int brackets = 0;
  while (!at_kind(TokenKind::end) && (brackets > 0 || !at(":"))) {
    if (at("(") || at("[") || at("{")) ++brackets;
    if (at(")") || at("]") || at("}")) --brackets;
    if (brackets < 0) break;
    take();
  }
  expect(":");
  return expression();
}

// starred → ('*' | '**') bitwise        not in the language
ExprPtr Parser::starred() {
  forbid("'" + std::string(peek().text) + "' before an expression", peek().at);
  take();
  return bitwise();
}

// target_list → star_target (',' star_target)* [',']
ExprPtr Parser::target_list() {
  const std::size_t begin = peek().at.begin;
  ExprPtr first = star_target();
  if (!at(",")) return first;
  ExprPtr tuple = make(ExprKind::tuple, begin);
  tuple->items.push_back(std::move(first));
  while (accept(",") && begins_expression()) tuple->items.push_back(star_target());
  return finish(std::move(tuple));
}

// star_target → primary        also '*' primary, which is not in the language
ExprPtr Parser::star_target() {
  if (at("*")) forbid("starred targets", take().at);
  return primary();
}

ExprPtr Parser::number() {
  const Token token = take();
  std::string text;
  for (const char c : token.text)
    if (c != '_') text += c;
  ExprPtr e = make(ExprKind::constant, token.at.begin);
  const char kind = text.size() > 1 && text[0] == '0' ? static_cast<char>(text[1] | 0x20) : '0';
  const int base = kind == 'x' ? 16 : kind == 'o' ? 8 : kind == 'b' ? 2 : 10;
  if (base == 10 && text.find_first_of(".eE") != std::string::npos) {
    e->value = Value(*parse_float(text));
  } else {
    const char* first = text.data() + (base == 10 ? 0 : 2);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(first, text.data() + text.size(), value, base);
    if (error == std::errc::result_out_of_range) forbid("an integer of more than 64 bits", token.at);
    e->value = Value(value);
  }
  return finish(std::move(e));
}

// strings → STRING+
ExprPtr Parser::strings() {
  ExprPtr e = make(ExprKind::fstring, peek().at.begin);
  while (at_kind(TokenKind::string)) string_literal(take(), e->items);
  // Neighbours that are constant are one constant; a string without fields is a constant itself.
  std::vector<ExprPtr> joined;
  for (ExprPtr& item : e->items) {
    const bool constant = item->kind == ExprKind::constant;
    if (constant && !joined.empty() && joined.back()->kind == ExprKind::constant) {
      joined.back()->value = Value(joined.back()->value.as_string() + item->value.as_string());
    } else {
      joined.push_back(std::move(item));
    }
  }
  e->items = std::move(joined);
  if (e->items.empty()) {
    e->kind = ExprKind::constant;
    e->value = Value("");
  } else if (e->items.size() == 1 && e->items[0]->kind == ExprKind::constant) {
    e->kind = ExprKind::constant;
    e->value = e->items[0]->value;
    e->items.clear();
  }
  return finish(std::move(e));
}

}  // namespace race::language
