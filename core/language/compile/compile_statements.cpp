// Compiling statements and targets.
#include <algorithm>

#include "core/language/compile/compiler_internal.h"

namespace race::language {

NodeId Compiler::block(const Block& statements) {
  std::vector<NodeId> run;
  const bool outer = service_;
  bool any = outer;
  for (const Stmt& s : statements) {
    service_ = false;
    run.push_back(statement(s));
    any = any || service_;
  }
  service_ = any;
  return emit_run(Opcode::block, statements.empty() ? Span{} : statements.front().at, run);
}

NodeId Compiler::statement(const Stmt& s) {
  switch (s.kind) {
    case StmtKind::expression: {
      const bool call = s.value->kind == ExprKind::call;
      const Path path = call ? path_of(*s.value->items[0]) : Path{};
      if (path.names.size() == 3 && path.names[0] == "svc") return service_call(*s.value);
      return emit(Opcode::evaluate, s.at, expression(*s.value));
    }
    case StmtKind::assign:
      return assignment(s);
    case StmtKind::augment:
      return augmentation(s);
    case StmtKind::branch:
      return branch(s);
    case StmtKind::for_loop: {
      const NodeId iterable = expression(*s.value);
      const NodeId variable = target(*s.targets[0]);
      const NodeId body = block(s.blocks[0]);
      return emit(Opcode::for_loop, s.at, variable, iterable, body);
    }
    case StmtKind::while_loop: {
      const NodeId test = boolean(*s.value);
      const NodeId body = block(s.blocks[0]);
      return emit(Opcode::while_loop, s.at, test, body);
    }
    case StmtKind::break_loop:
      return emit(Opcode::break_loop, s.at);
    case StmtKind::continue_loop:
      return emit(Opcode::continue_loop, s.at);
    default:
      return emit(Opcode::pass, s.at);
  }
}

NodeId Compiler::assignment(const Stmt& s) {
  NodeId value = 0;
  if (s.value->kind == ExprKind::tuple) {
    std::vector<const Expr*> parts;
    for (const ExprPtr& item : s.value->items) parts.push_back(item.get());
    value = emit_run(Opcode::list, s.value->at, operands(parts));
  } else {
    value = expression(*s.value);
  }
  if (s.targets.size() == 1) {
    const NodeId only = target(*s.targets[0]);
    const Node node = program_->nodes[only];
    if (node.op == Opcode::target_local) return emit(Opcode::assign_local, s.at, value, node.a);
    if (node.op == Opcode::target_slot) return emit(Opcode::assign_slot, s.at, value, node.a);
    return emit_run(Opcode::assign, s.at, {only}, value);
  }
  std::vector<NodeId> targets;
  for (const ExprPtr& t : s.targets) targets.push_back(target(*t));
  return emit_run(Opcode::assign, s.at, targets, value);
}

NodeId Compiler::augmentation(const Stmt& s) {
  const Expr& t = *s.targets[0];
  const auto op = static_cast<std::uint32_t>(s.op);
  if (t.kind == ExprKind::index) {
    const std::uint32_t where = place(t, true);
    return emit(Opcode::augment_place, s.at, where, expression(*s.value), op);
  }
  const NodeId only = target(t);
  const Node node = program_->nodes[only];
  const NodeId value = expression(*s.value);
  if (node.op == Opcode::target_local) return emit(Opcode::augment_local, s.at, node.a, value, op);
  reads(node.a);
  return emit(Opcode::augment_slot, s.at, node.a, value, op);
}

NodeId Compiler::branch(const Stmt& s) {
  std::vector<NodeId> run;
  for (std::size_t i = 0; i < s.blocks.size(); ++i) {
    if (i < s.tests.size()) run.push_back(boolean(*s.tests[i]));
    run.push_back(block(s.blocks[i]));
  }
  return emit_run(Opcode::branch, s.at, run);
}

NodeId Compiler::service_call(const Expr& e) {
  service_ = true;
  const Path path = path_of(*e.items[0]);
  ServiceCallSite site;
  site.name = name_constant(path.names[2]);
  if (path.service != nullptr) {
    site.service = expression(*path.service);
    services_.open_operation(path.names[2]);
    for (OperationId id = 0; id < services_.operations().size(); ++id)
      if (services_.operations()[id].name == path.names[2]) calls_.insert(id);
  } else {
    site.service_name = name_constant(path.names[1]);
    site.operation = services_.operation(path.names[1], path.names[2]);
    calls_.insert(site.operation);
  }
  const std::size_t positional = e.items.size() - 1 - e.keywords.size();
  for (std::size_t i = 0; i < positional; ++i) site.arguments.push_back(expression(*e.items[i + 1]));
  for (std::size_t i = 0; i < e.keywords.size(); ++i) {
    const NodeId value = expression(*e.items[1 + positional + i]);
    site.keywords.emplace_back(name_constant(e.keywords[i]), value);
  }
  program_->calls.push_back(std::move(site));
  return emit(Opcode::call_service, e.at, static_cast<std::uint32_t>(program_->calls.size() - 1));
}

NodeId Compiler::target(const Expr& e) {
  if (e.kind == ExprKind::tuple || e.kind == ExprKind::list) {
    std::vector<NodeId> run;
    for (const ExprPtr& item : e.items) run.push_back(target(*item));
    return emit_run(Opcode::target_unpack, e.at, run);
  }
  if (e.kind == ExprKind::name) return emit(Opcode::target_local, e.at, local(e.name));
  if (e.kind == ExprKind::attribute) {
    const Reference r = resolve(e, program_->kind, symbols_);
    writes_.insert(r.number);
    return emit(Opcode::target_slot, e.at, r.number);
  }
  return emit(Opcode::target_place, e.at, place(e, true));
}

// The place of a name, a path and indices: its root and the steps from there.
std::uint32_t Compiler::place(const Expr& e, bool writes) {
  Place made;
  std::vector<Place::Step> steps;
  const Expr* at = &e;
  for (;;) {
    if (at->kind == ExprKind::name) {
      made.root = local(at->name);
      break;
    }
    const Reference r = resolve(*at, program_->kind, symbols_);
    if (r.meaning == Meaning::value) {
      made.local = false;
      made.root = r.number;
      reads(r.number);
      if (writes) writes_.insert(r.number);
      break;
    }
    Place::Step step;
    if (at->kind == ExprKind::attribute) {
      step.field = name_constant(at->name);
    } else {
      step.key = expression(*at->items[1]);
    }
    steps.push_back(step);
    at = at->items[0].get();
  }
  made.steps.assign(steps.rbegin(), steps.rend());
  program_->places.push_back(std::move(made));
  return static_cast<std::uint32_t>(program_->places.size() - 1);
}

}  // namespace race::language
