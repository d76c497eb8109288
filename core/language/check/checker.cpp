#include "core/language/check/checker.h"

#include <algorithm>
#include <map>

#include "core/language/check/names.h"
#include "core/language/library/functions.h"
#include "core/language/syntax/parser.h"
#include "core/value/error_list.h"

namespace race::language {
namespace {

class Checker {
 public:
  Checker(CodeKind kind, const Symbols& symbols) : kind_(kind), symbols_(symbols) {}

  std::vector<Problem> run(const Tree& tree) {
    if (tree.expression) {
      expression(*tree.expression);
    } else {
      locals_ = assigned_names(tree.statements);
      block(tree.statements);
    }
    return std::move(problems_);
  }

 private:
  void report(ErrorCode code, std::string message, const Expr& e) { add({code, std::move(message), e.at}); }

  void add(Problem problem) {
    if (found_[problem.code]++ <= kMaxErrors) problems_.push_back(std::move(problem));
  }

  // Statements.
  void block(const Block& statements) {
    for (const Stmt& s : statements) statement(s);
  }

  void statement(const Stmt& s) {
    for (const ExprPtr& test : s.tests) expression(*test);
    if (s.value) {
      const bool call = s.kind == StmtKind::expression && s.value->kind == ExprKind::call;
      if (call && is_operation(*s.value->items[0])) {
        service_call(*s.value);
      } else {
        expression(*s.value);
      }
    }
    for (const ExprPtr& t : s.targets) target(*t, s.kind == StmtKind::augment);
    for (const Block& inner : s.blocks) block(inner);
  }

  // svc.S.op or svc[e].op, called
  static bool is_operation(const Expr& callee) {
    const Path path = path_of(callee);
    return path.names.size() == 3 && path.names[0] == "svc";
  }

  void service_call(const Expr& call) {
    const Path path = path_of(*call.items[0]);
    if (path.service != nullptr) expression(*path.service);
    dunder(path.names[2], *call.items[0]);
    arguments(call);
  }

  void dunder(std::string_view name, const Expr& e) {
    if (name.substr(0, 2) == "__") report(ErrorCode::forbidden, "names that begin with __", e);
  }

  // A target of an assignment; `read` if its old value is used.
  void target(const Expr& e, bool read) {
    switch (e.kind) {
      case ExprKind::tuple:
      case ExprKind::list:
        for (const ExprPtr& item : e.items) target(*item, read);
        return;
      case ExprKind::name:
        dunder(e.name, e);
        if (is_reserved(e.name)) report(ErrorCode::scope, e.name + " is a reserved name", e);
        return;
      case ExprKind::attribute:
        return attribute_target(e);
      case ExprKind::index:
        return index_target(e);
      default:
        return;  // the parser has reported it
    }
  }

  void attribute_target(const Expr& e) {
    const Reference reference = resolve(e, kind_, symbols_);
    const std::string_view root = root_of(e);
    if (reference.meaning == Meaning::value && reference.writable) return dunder(e.name, e);
    if (reference.meaning == Meaning::invalid && reference.problem.code == ErrorCode::unknown_name && root == "res")
      return add(reference.problem);
    const bool of_value = (root == "res" || root == "var") && reference.meaning == Meaning::other;
    if (is_reserved(root) && !of_value)
      return report(ErrorCode::scope, std::string(root) + " cannot be written like this", e);
    report(ErrorCode::forbidden, "an attribute as a target: write d['key'] for d.key", e);
  }

  void index_target(const Expr& e) {
    const std::string_view root = root_of(e);
    if (is_reserved(root) && root != "res" && root != "var")
      return report(ErrorCode::scope, std::string(root) + " cannot be written", e);
    const Expr* base = &e;
    while (base->kind == ExprKind::index) base = base->items[0].get();
    if (base->kind == ExprKind::name && is_collection(base->name))
      return report(ErrorCode::scope, base->name + " as a whole cannot be written", e);
    expression(*e.items[0]);
    expression(*e.items[1]);
  }

  // Expressions.
  void expression(const Expr& e) {
    switch (e.kind) {
      case ExprKind::name:
      case ExprKind::attribute:
      case ExprKind::index:
        return path(e);
      case ExprKind::call:
        return call(e);
      case ExprKind::comprehension:
        return comprehension(e);
      case ExprKind::tuple:  // the parser has reported tuples in places that have none
      default:
        return for_each_part(e, [&](const Expr& part) { expression(part); });
    }
  }

  void path(const Expr& e) {
    if (e.kind != ExprKind::index) dunder(e.name, e);
    const Reference reference = resolve(e, kind_, symbols_);
    if (reference.dynamic != nullptr) expression(*reference.dynamic);
    if (reference.meaning == Meaning::invalid) return add(reference.problem);
    if (reference.meaning != Meaning::other) return;
    if (e.kind != ExprKind::name) return for_each_part(e, [&](const Expr& part) { expression(part); });
    if (std::find(locals_.begin(), locals_.end(), e.name) == locals_.end())
      report(ErrorCode::unknown_name, e.name + " is not known here", e);
  }

  void comprehension(const Expr& e) {
    const std::size_t outer = locals_.size();
    for (const Clause& clause : e.clauses) {
      expression(*clause.iterable);
      target(*clause.target, false);
      comprehension_names(*clause.target);
      for (const ExprPtr& filter : clause.filters) expression(*filter);
    }
    expression(*e.items[0]);
    locals_.resize(outer);
  }

  // The targets of a comprehension are names: it cannot write anything else.
  void comprehension_names(const Expr& target) {
    for_each_name(target, [&](const Expr& name) { locals_.push_back(name.name); });
    const auto other = [&](const Expr& part) {
      if (part.kind == ExprKind::attribute || part.kind == ExprKind::index)
        report(ErrorCode::forbidden, "a comprehension's target is a name", part);
    };
    other(target);
    if (target.kind == ExprKind::tuple || target.kind == ExprKind::list)
      for (const ExprPtr& item : target.items) other(*item);
  }

  void call(const Expr& e) {
    const Expr& callee = *e.items[0];
    if (is_operation(callee)) {
      if (kind_ == CodeKind::expression) {
        report(ErrorCode::scope, "svc is not visible in a parameter's expression", e);
      } else {
        report(ErrorCode::service_call, "an operation is called by a statement of its own", e);
      }
      return service_call(e);
    }
    if (callee.kind == ExprKind::name) {
      plain_call(e, callee);
    } else if (callee.kind == ExprKind::attribute) {
      const Path path = path_of(callee);
      if (path.names.size() == 2 && is_module(path.names[0])) {
        module_call(e, path);
      } else {
        method_call(e, callee);
      }
    } else {
      report(ErrorCode::forbidden, "only functions, methods and operations can be called", e);
      expression(callee);
    }
    arguments(e);
  }

  void arguments(const Expr& call) {
    for (std::size_t i = 1; i < call.items.size(); ++i) expression(*call.items[i]);
    for (const std::string& name : call.keywords) dunder(name, call);
  }

  void plain_call(const Expr& e, const Expr& callee) {
    if (is_builtin(callee.name)) {
      const Function* function = find_function("", callee.name);
      if (callee.name != "dict") keywords(e, function == nullptr ? "" : function->parameters);
      return;
    }
    const bool known =
        is_reserved(callee.name) || std::find(locals_.begin(), locals_.end(), callee.name) != locals_.end();
    report(known ? ErrorCode::forbidden : ErrorCode::unknown_name, callee.name + " is no function", callee);
  }

  void module_call(const Expr& e, const Path& path) {
    const Function* function = find_function(path.names[0], path.names[1]);
    if (function == nullptr)
      return report(ErrorCode::unknown_name, std::string(path.names[0]) + " has no " + std::string(path.names[1]), e);
    keywords(e, function->parameters);
  }

  void method_call(const Expr& e, const Expr& callee) {
    const Expr& object = *callee.items[0];
    dunder(callee.name, callee);
    const Method* method = find_method(callee.name);
    if (method == nullptr) {
      report(ErrorCode::forbidden, "there is no method " + callee.name, callee);
    } else {
      keywords(e, method->parameters());
      if (method->mutates()) change(e, object);
    }
    expression(object);
  }

  void change(const Expr& e, const Expr& object) {
    if (kind_ != CodeKind::function)
      return report(ErrorCode::effect, "a method that changes a value, outside of a function", e);
    const std::string_view root = root_of(object);
    const bool whole = object.kind == ExprKind::name && is_collection(object.name);
    if (is_reserved(root) && (whole || (root != "res" && root != "var")))
      report(ErrorCode::scope, std::string(root) + " cannot be written", e);
  }

  void keywords(const Expr& call, std::string_view parameters) {
    const Signature known = signature(parameters);
    for (const std::string& name : call.keywords) {
      const bool found = std::any_of(known.parameters.begin(), known.parameters.end(),
                                     [&](const Signature::Parameter& p) { return p.by_name && p.name == name; });
      if (!found) report(ErrorCode::forbidden, "there is no argument named " + name + " here", call);
    }
  }

  CodeKind kind_;
  const Symbols& symbols_;
  std::vector<std::string> locals_;
  std::vector<Problem> problems_;
  // How many were found of each code: enough of each are kept, as who calls leaves out those of some codes.
  std::map<ErrorCode, std::size_t> found_;
};

void find_variables(const Expr& e, std::vector<std::string>& names) {
  const bool of_var = e.kind == ExprKind::attribute && e.items[0]->kind == ExprKind::name && e.items[0]->name == "var";
  if (of_var && std::find(names.begin(), names.end(), e.name) == names.end()) names.push_back(e.name);
  for_each_part(e, [&](const Expr& part) { find_variables(part, names); });
}

void find_variables(const Block& block, std::vector<std::string>& names) {
  for (const Stmt& s : block) {
    for (const ExprPtr& test : s.tests) find_variables(*test, names);
    if (s.value) find_variables(*s.value, names);
    for (const ExprPtr& target : s.targets) find_variables(*target, names);
    for (const Block& inner : s.blocks) find_variables(inner, names);
  }
}

}  // namespace

std::vector<Error> check(std::string_view text, CodeKind kind, const Symbols& symbols) {
  Parsed parsed = parse(text, kind);
  const auto is_syntax = [](const Problem& p) { return p.code == ErrorCode::syntax; };
  if (std::none_of(parsed.problems.begin(), parsed.problems.end(), is_syntax)) {
    std::vector<Problem> more = Checker(kind, symbols).run(parsed.tree);
    parsed.problems.insert(parsed.problems.end(), more.begin(), more.end());
  }
  std::vector<Error> errors;
  for (Problem& p : parsed.problems) errors.push_back({p.code, std::move(p.message), {}, range_of(text, p.at)});
  return errors;
}

std::vector<std::string> variable_names(std::string_view text) {
  // An expression is a function of one statement, so this reads all three kinds of code.
  Parsed parsed = parse(text, CodeKind::function);
  if (!parsed.problems.empty()) parsed = parse(text, CodeKind::condition);
  std::vector<std::string> names;
  if (!parsed.problems.empty()) return names;
  if (parsed.tree.expression) find_variables(*parsed.tree.expression, names);
  find_variables(parsed.tree.statements, names);
  return names;
}

}  // namespace race::language
