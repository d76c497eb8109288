// Compiling expressions.
#include "core/language/compile/compiler_internal.h"

namespace race::language {

// Operands of and, or, not; tests; filters; a whole condition: there svc.S.ev by itself asks for presence.
NodeId Compiler::boolean(const Expr& e) {
  const Reference r = resolve(e, program_->kind, symbols_);
  if (r.meaning == Meaning::other) return expression(e);
  const bool outer = service_;
  service_ = false;
  const NodeId id = reference(e, r, true);
  service_ = service_ || outer;
  return id;
}

NodeId Compiler::expression(const Expr& e) {
  const bool outer = service_;
  service_ = false;
  NodeId id = 0;
  switch (e.kind) {
    case ExprKind::constant:
      id = emit(Opcode::constant, e.at, constant(e.value));
      break;
    case ExprKind::name:
    case ExprKind::attribute:
    case ExprKind::index: {
      const Reference r = resolve(e, program_->kind, symbols_);
      if (r.meaning != Meaning::other) {
        id = reference(e, r, false);
      } else if (e.kind == ExprKind::name) {
        id = emit(Opcode::local, e.at, local(e.name));
      } else if (e.kind == ExprKind::attribute) {
        const NodeId object = expression(*e.items[0]);
        id = emit(Opcode::field, e.at, object, name_constant(e.name));
      } else {
        const std::vector<NodeId> parts = operands(pointers(e.items));
        id = emit(Opcode::index, e.at, parts[0], parts[1]);
      }
      break;
    }
    case ExprKind::slice:
      id = emit_run(Opcode::slice, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::call:
      id = call(e);
      break;
    case ExprKind::unary:
      id = emit(opcode(e.unary_op), e.at,
                e.unary_op == UnaryOperator::logical_not ? boolean(*e.items[0]) : expression(*e.items[0]));
      break;
    case ExprKind::binary:
      id = binary(e);
      break;
    case ExprKind::compare:
      id = comparison(e);
      break;
    case ExprKind::logical: {
      std::vector<NodeId> run;
      for (const ExprPtr& item : e.items) run.push_back(boolean(*item));
      id = emit_run(opcode(e.op), e.at, run);
      break;
    }
    case ExprKind::conditional: {
      const NodeId test = boolean(*e.items[0]);
      const NodeId yes = expression(*e.items[1]);
      const NodeId no = expression(*e.items[2]);
      id = emit(Opcode::conditional, e.at, test, yes, no);
      break;
    }
    case ExprKind::list:
    case ExprKind::tuple:
      id = emit_run(Opcode::list, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::dict:
      id = emit_run(Opcode::dict, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::comprehension:
      id = comprehension(e);
      break;
    case ExprKind::fstring:
      id = emit_run(Opcode::fstring, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::format: {
      const std::vector<NodeId> parts = operands(pointers(e.items));
      id = emit(Opcode::format, e.at, parts[0], parts[1], static_cast<std::uint32_t>(e.conversion));
      break;
    }
  }
  service_ = service_ || outer;
  return id;
}

NodeId Compiler::binary(const Expr& e) {
  const std::vector<NodeId> parts = operands(pointers(e.items));
  return emit(opcode(e.op), e.at, parts[0], parts[1]);
}

NodeId Compiler::comparison(const Expr& e) {
  const std::vector<NodeId> parts = operands(pointers(e.items));
  if (parts.size() == 2) return emit(opcode(e.operators[0]), e.at, parts[0], parts[1]);
  std::vector<std::uint32_t> run = {parts[0]};
  for (std::size_t i = 0; i < e.operators.size(); ++i) {
    run.push_back(static_cast<std::uint32_t>(e.operators[i]));
    run.push_back(parts[i + 1]);
  }
  return emit_run(Opcode::chain, e.at, run);
}

NodeId Compiler::comprehension(const Expr& e) {
  const std::size_t outer = scope_.size();
  std::vector<ComprehensionClause> clauses;
  for (const Clause& clause : e.clauses) {
    ComprehensionClause made{};
    made.iterable = expression(*clause.iterable);
    for_each_name(*clause.target, [&](const Expr& name) {
      scope_.emplace_back(name.name, static_cast<std::uint32_t>(program_->locals.size()));
      program_->locals.push_back(name.name);
    });
    made.target = target(*clause.target);
    for (const ExprPtr& filter : clause.filters) made.filters.push_back(boolean(*filter));
    clauses.push_back(std::move(made));
  }
  const NodeId element = expression(*e.items[0]);
  scope_.resize(outer);
  program_->comprehensions.push_back(std::move(clauses));
  return emit(Opcode::comprehension, e.at, element, static_cast<std::uint32_t>(program_->comprehensions.size() - 1));
}

}  // namespace race::language
