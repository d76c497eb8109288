// Names: what a name or a path of names in code means (SEMANTICS.md section 2, Scopes). Used by the checker, which
// reports problems, and by the compiler, which needs the index in Δ.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/language/interface/symbols.h"
#include "core/language/syntax/ast.h"
#include "core/language/syntax/lexer.h"

namespace race::language {

/// A name with attributes: `chi.A.res.x` is {chi, A, res, x}; `svc[e].op` is {svc, "", op} with `service` = e.
struct Path {
  std::vector<std::string_view> names;  // empty: the expression is no path
  const Expr* service = nullptr;        // the dynamic name of a service
};
Path path_of(const Expr& e);

enum class Meaning : std::uint8_t {
  other,       // no reference: a local name, an attribute of a value, any other expression
  invalid,     // see `problem`
  collection,  // par, res or var as a whole
  value,       // a slot of Δ
  flag,        // a flag of Δ
  child_name,  // text
  data,        // svc.S.ev: data of an event
  latest,      // svc.S.ev.latest
  result,      // svc.S.op.result
  error,       // svc.S.op.error
  constant,    // math.pi
};

struct Reference {
  Meaning meaning = Meaning::other;
  std::uint32_t number = 0;        // slot or flag
  bool writable = false;           // a result or variable
  std::string_view text;           // of a child_name or collection
  std::string_view service, name;  // of service data
  const Expr* dynamic = nullptr;   // instead of `service`
  const Value* constant = nullptr;
  Problem problem;
};

/// The meaning of a name or path as a value. `undeclared_variables`: var.x has a meaning although `symbols` has no x.
Reference resolve(const Expr& e, CodeKind kind, const Symbols& symbols);

/// par, res, var, port, chi, svc.
bool is_collection(std::string_view name);
/// Names that code cannot give a value: collections, builtins and modules.
bool is_reserved(std::string_view name);

/// The name at the root of a path that may be indexed: `a.b[i].c` gives `a`; empty if there is none.
std::string_view root_of(const Expr& e);

/// Calls `visit(name)` for every plain name in a target.
template <typename Visit>
void for_each_name(const Expr& target, Visit&& visit) {
  if (target.kind == ExprKind::name) visit(target);
  if (target.kind == ExprKind::tuple || target.kind == ExprKind::list)
    for (const ExprPtr& item : target.items) for_each_name(*item, visit);
}

/// The plain names that statements give values to, in order of appearance, each once.
std::vector<std::string> assigned_names(const Block& block);

}  // namespace race::language
