// The compiler's class: its expressions are in compile_expressions.cpp, its statements in compile_statements.cpp.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/language/check/names.h"
#include "core/language/compile/code.h"
#include "core/language/compile/program.h"
#include "core/language/syntax/ast.h"

namespace race::language {

class Compiler {
 public:
  Compiler(std::string_view text, CodeKind kind, const Symbols& symbols, ServiceTable& services);

  /// Compiles a tree that the checker found nothing in.
  Code run(const Tree& tree);

 private:
  // statements
  NodeId block(const Block& statements);
  NodeId statement(const Stmt& s);
  NodeId assignment(const Stmt& s);
  NodeId augmentation(const Stmt& s);
  NodeId branch(const Stmt& s);
  NodeId service_call(const Expr& e);
  NodeId target(const Expr& e);
  std::uint32_t place(const Expr& e, bool writes);

  // expressions
  NodeId expression(const Expr& e);
  NodeId boolean(const Expr& e);  // an expression in a boolean position
  NodeId reference(const Expr& e, const Reference& r, bool boolean_position);
  NodeId service_read(const Expr& e, const Reference& r, bool boolean_position);
  NodeId dynamic_read(const Expr& e, const Reference& r, bool boolean_position);
  NodeId collection(const Expr& e, std::string_view name);
  NodeId binary(const Expr& e);
  NodeId comparison(const Expr& e);
  NodeId comprehension(const Expr& e);
  NodeId call(const Expr& e);
  NodeId function_call(const Expr& e, const Function& function, std::string_view name);
  NodeId method_call(const Expr& e);
  bool bind(const Expr& call, std::string_view parameters, std::vector<NodeId>& arguments, std::string& problem);

  // nodes
  NodeId emit(Opcode op, Span at, std::uint32_t a = 0, std::uint32_t b = 0, std::uint32_t c = 0);
  NodeId emit_run(Opcode op, Span at, const std::vector<std::uint32_t>& run, std::uint32_t b = 0, std::uint32_t c = 0);
  std::vector<NodeId> operands(const std::vector<const Expr*>& parts);
  NodeId copied_if(NodeId node, bool changes_later);
  std::uint32_t constant(Value value);
  std::uint32_t name_constant(std::string_view name) { return constant(Value(name)); }
  std::uint32_t local(std::string_view name);
  static bool changes(const Expr& e);

  // what the code mentions
  void reads(ValueIndex slot) { reads_.insert(slot); }
  Code finish();

  const Symbols& symbols_;
  ServiceTable& services_;
  std::shared_ptr<Program> program_;
  std::map<std::string, std::uint32_t, std::less<>> names_;   // constants that are strings
  std::vector<std::pair<std::string, std::uint32_t>> scope_;  // visible locals; a later one hides an earlier one
  bool service_ = false;                                      // the expression being compiled contains svc
  std::set<EventId> events_, latest_;
  std::set<OperationId> responses_, calls_;
  std::set<ValueIndex> reads_, writes_;
  std::set<Flag> flags_;
};

}  // namespace race::language
