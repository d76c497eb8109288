// The syntax tree of a code text. It holds names as written: what they mean is found by names.h.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/language/syntax/operators.h"
#include "core/language/syntax/source.h"
#include "core/value/value.h"

namespace race::language {

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;

enum class ExprKind : std::uint8_t {
  constant,       // value
  name,           // name
  attribute,      // items[0].name
  index,          // items[0][items[1]]
  slice,          // items[0][items[1]:items[2]:items[3]], any but the first may be null
  call,           // items[0](items[1], ...), the last of them under `keywords`
  unary,          // unary_op items[0]
  binary,         // items[0] op items[1]
  compare,        // items[0] operators[0] items[1] operators[1] items[2] ...; of is_none the right side is null
  logical,        // items joined by op, logical_and or logical_or
  conditional,    // items: test, value if true, value if false
  list,           // items
  tuple,          // items; on the right of an unpacking and as a target only
  dict,           // items: key, value, key, value, ...
  comprehension,  // items[0] for clauses
  fstring,        // items: constants and `format`s
  format,         // items[0] printed after `conversion` (r, s, a or 0) to the format items[1] (fstring or null)
};

/// for target in iterable if filters
struct Clause {
  ExprPtr target;
  ExprPtr iterable;
  std::vector<ExprPtr> filters;
};

struct Expr {
  ExprKind kind = ExprKind::constant;
  UnaryOperator unary_op = UnaryOperator::negative;
  BinaryOperator op = BinaryOperator::add;
  char conversion = 0;
  std::uint16_t depth = 1;  // levels of the tree below and with this
  Span at;
  Value value;
  std::string name;
  std::vector<ExprPtr> items;
  std::vector<BinaryOperator> operators;
  std::vector<std::string> keywords;
  std::vector<Clause> clauses;
};

struct Stmt;
using Block = std::vector<Stmt>;

enum class StmtKind : std::uint8_t {
  expression,  // value
  assign,      // targets = value, each in order
  augment,     // targets[0] op= value
  branch,      // if tests[i]: blocks[i]; a last block without test is `else`
  for_loop,    // for targets[0] in value: blocks[0]
  while_loop,  // while value: blocks[0]
  break_loop,
  continue_loop,
  pass,
};

struct Stmt {
  StmtKind kind = StmtKind::pass;
  BinaryOperator op = BinaryOperator::add;
  Span at;
  std::vector<ExprPtr> targets;
  ExprPtr value;
  std::vector<ExprPtr> tests;
  std::vector<Block> blocks;
};

/// What parsing gives: `condition` for COND and EXPR, `statements` for CODE.
struct Tree {
  ExprPtr expression;
  Block statements;
};

/// The items of an expression, to be read.
inline std::vector<const Expr*> pointers(const std::vector<ExprPtr>& items) {
  std::vector<const Expr*> parts;
  for (const ExprPtr& item : items) parts.push_back(item.get());
  return parts;
}

/// Calls `visit(child)` for each direct part of an expression, clauses included, in the order of the text.
template <typename Visit>
void for_each_part(const Expr& e, Visit&& visit) {
  for (const ExprPtr& item : e.items)
    if (item) visit(*item);
  for (const Clause& clause : e.clauses) {
    visit(*clause.target);
    visit(*clause.iterable);
    for (const ExprPtr& filter : clause.filters) visit(*filter);
  }
}

}  // namespace race::language
