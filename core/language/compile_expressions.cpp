// Compiling expressions.
#include <algorithm>

#include "core/language/compiler_internal.h"

namespace race::language {
namespace {

Op op_of(Operator op) {
  static_assert(static_cast<int>(Op::is_not_none) - static_cast<int>(Op::add) ==
                static_cast<int>(Operator::is_not_none) - static_cast<int>(Operator::add));
  return static_cast<Op>(static_cast<int>(Op::add) + static_cast<int>(op) - static_cast<int>(Operator::add));
}

std::vector<const Expr*> pointers(const std::vector<ExprPtr>& items) {
  std::vector<const Expr*> parts;
  for (const ExprPtr& item : items) parts.push_back(item.get());
  return parts;
}

}  // namespace

// Operands of and, or, not; tests; filters; a whole condition: there a bare svc.S.ev asks for presence.
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
      id = emit(Op::constant, e.at, constant(e.value));
      break;
    case ExprKind::name:
    case ExprKind::attribute:
    case ExprKind::index: {
      const Reference r = resolve(e, program_->kind, symbols_);
      if (r.meaning != Meaning::other) {
        id = reference(e, r, false);
      } else if (e.kind == ExprKind::name) {
        id = emit(Op::local, e.at, local(e.name));
      } else if (e.kind == ExprKind::attribute) {
        const NodeId object = expression(*e.items[0]);
        id = emit(Op::field, e.at, object, name_constant(e.name));
      } else {
        const std::vector<NodeId> parts = operands(pointers(e.items));
        id = emit(Op::index, e.at, parts[0], parts[1]);
      }
      break;
    }
    case ExprKind::slice:
      id = emit_run(Op::slice, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::call:
      id = call(e);
      break;
    case ExprKind::unary: {
      const bool negation = e.op == Operator::logical_not;
      const NodeId operand = negation ? boolean(*e.items[0]) : expression(*e.items[0]);
      id = emit(negation ? Op::logical_not : e.op == Operator::negative ? Op::negative : Op::positive, e.at, operand);
      break;
    }
    case ExprKind::binary:
      id = binary(e);
      break;
    case ExprKind::compare:
      id = comparison(e);
      break;
    case ExprKind::logical: {
      std::vector<NodeId> run;
      for (const ExprPtr& item : e.items) run.push_back(boolean(*item));
      id = emit_run(e.op == Operator::logical_and ? Op::logical_and : Op::logical_or, e.at, run);
      break;
    }
    case ExprKind::conditional: {
      const NodeId test = boolean(*e.items[0]);
      const NodeId yes = expression(*e.items[1]);
      const NodeId no = expression(*e.items[2]);
      id = emit(Op::conditional, e.at, test, yes, no);
      break;
    }
    case ExprKind::list:
    case ExprKind::tuple:
      id = emit_run(Op::list, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::dict:
      id = emit_run(Op::dict, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::comprehension:
      id = comprehension(e);
      break;
    case ExprKind::fstring:
      id = emit_run(Op::fstring, e.at, operands(pointers(e.items)));
      break;
    case ExprKind::format: {
      const std::vector<NodeId> parts = operands(pointers(e.items));
      id = emit(Op::format, e.at, parts[0], parts[1], static_cast<std::uint32_t>(e.conversion));
      break;
    }
  }
  service_ = service_ || outer;
  return id;
}

NodeId Compiler::reference(const Expr& e, const Reference& r, bool boolean_position) {
  switch (r.meaning) {
    case Meaning::collection:
      return collection(e, r.text);
    case Meaning::value:
      reads(r.number);
      return emit(Op::slot, e.at, r.number);
    case Meaning::flag:
      flags_.insert(r.number);
      return emit(Op::flag, e.at, r.number);
    case Meaning::child_name:
      return emit(Op::constant, e.at, name_constant(r.text));
    case Meaning::constant:
      return emit(Op::constant, e.at, constant(*r.constant));
    default:
      return r.dynamic != nullptr ? dynamic_read(e, r, boolean_position) : service_read(e, r, boolean_position);
  }
}

NodeId Compiler::service_read(const Expr& e, const Reference& r, bool boolean_position) {
  service_ = true;
  program_->mentions.svc = true;
  if (r.meaning == Meaning::data) {
    const EventId event = services_.event(r.service, r.name);
    events_.insert(event);
    return emit(boolean_position ? Op::event_present : Op::event, e.at, event);
  }
  if (r.meaning == Meaning::latest) {
    const EventId event = services_.event(r.service, r.name);
    latest_.insert(event);
    return emit(Op::event_latest, e.at, event);
  }
  // `result` and `error` of a known event that is no operation are fields of its data.
  const EventId event = services_.find_event(r.service, r.name);
  if (event != kNone && services_.find_operation(r.service, r.name) == kNone) {
    events_.insert(event);
    return emit(Op::field, e.at, emit(Op::event, e.at, event), name_constant(e.name));
  }
  const OperationId operation = services_.operation(r.service, r.name);
  responses_.insert(operation);
  const std::uint32_t error = r.meaning == Meaning::error ? 1 : 0;
  return emit(boolean_position ? Op::response_present : Op::response, e.at, operation, error);
}

NodeId Compiler::dynamic_read(const Expr& e, const Reference& r, bool boolean_position) {
  const NodeId service = expression(*r.dynamic);
  service_ = true;
  program_->mentions.svc = true;
  const std::uint32_t name = name_constant(r.name);
  bool is_event = r.meaning == Meaning::data || r.meaning == Meaning::latest;
  bool known_event = false;
  bool known_operation = false;
  for (const auto& event : services_.events()) known_event = known_event || event.name == r.name;
  for (const auto& operation : services_.operations()) known_operation = known_operation || operation.name == r.name;
  const bool field = !is_event && known_event && !known_operation;
  if (is_event || field) {
    std::set<EventId>& mentioned = r.meaning == Meaning::latest ? latest_ : events_;
    for (EventId id = 0; id < services_.events().size(); ++id)
      if (services_.events()[id].name == r.name) mentioned.insert(id);
    const DynamicRead how = r.meaning == Meaning::latest ? DynamicRead::latest
                            : boolean_position && !field ? DynamicRead::present
                                                         : DynamicRead::data;
    const NodeId data = emit(Op::dynamic_event, e.at, service, name, static_cast<std::uint32_t>(how));
    return field ? emit(Op::field, e.at, data, name_constant(e.name)) : data;
  }
  for (OperationId id = 0; id < services_.operations().size(); ++id)
    if (services_.operations()[id].name == r.name) responses_.insert(id);
  const std::uint32_t bits = (r.meaning == Meaning::error ? 1U : 0U) | (boolean_position ? 2U : 0U);
  return emit(Op::dynamic_response, e.at, service, name, bits);
}

NodeId Compiler::collection(const Expr& e, std::string_view name) {
  const auto& slots = name == "par" ? symbols_.parameters : name == "res" ? symbols_.results : symbols_.variables;
  Collection made;
  for (const auto& [key, slot] : slots) {
    made.entries.emplace_back(name_constant(key), slot);
    reads(slot);
  }
  program_->collections.push_back(std::move(made));
  return emit(Op::collection, e.at, static_cast<std::uint32_t>(program_->collections.size() - 1));
}

NodeId Compiler::binary(const Expr& e) {
  const std::vector<NodeId> parts = operands(pointers(e.items));
  return emit(op_of(e.op), e.at, parts[0], parts[1]);
}

NodeId Compiler::comparison(const Expr& e) {
  const std::vector<NodeId> parts = operands(pointers(e.items));
  if (parts.size() == 2) return emit(op_of(e.operators[0]), e.at, parts[0], parts[1]);
  std::vector<std::uint32_t> run = {parts[0]};
  for (std::size_t i = 0; i < e.operators.size(); ++i) {
    run.push_back(static_cast<std::uint32_t>(op_of(e.operators[i])));
    run.push_back(parts[i + 1]);
  }
  return emit_run(Op::chain, e.at, run);
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
  return emit(Op::comprehension, e.at, element, static_cast<std::uint32_t>(program_->comprehensions.size() - 1));
}

NodeId Compiler::call(const Expr& e) {
  const Expr& callee = *e.items[0];
  const Path path = path_of(callee);
  if (callee.kind == ExprKind::name && callee.name == "available" && e.items.size() == 2 && e.keywords.empty()) {
    const NodeId operand = boolean(*e.items[1]);
    return emit(Op::available, e.at, operand);
  }
  if (callee.kind == ExprKind::name && callee.name == "available") {
    const std::vector<const Expr*> arguments = pointers(e.items);
    return emit_run(Op::wrong_call, e.at, operands({arguments.begin() + 1, arguments.end()}),
                    constant(Value("available() takes exactly one argument")));
  }
  if (callee.kind == ExprKind::name) return function_call(e, *find_function("", callee.name), callee.name);
  if (path.names.size() == 2 && is_module(path.names[0]))
    return function_call(e, *find_function(path.names[0], path.names[1]), path.names[1]);
  return method_call(e);
}

NodeId Compiler::function_call(const Expr& e, const Function& function, std::string_view name) {
  std::vector<NodeId> arguments;
  std::string problem;
  if (!bind(e, function.parameters, arguments, problem))
    return emit_run(Op::wrong_call, e.at, arguments, constant(Value(std::string(name) + "() " + problem)));
  program_->functions.push_back(&function);
  return emit_run(Op::function, e.at, arguments, static_cast<std::uint32_t>(program_->functions.size() - 1));
}

// Orders the arguments of a call by parameters. If they do not fit, `arguments` holds all of them as written.
bool Compiler::bind(const Expr& call, std::string_view parameters, std::vector<NodeId>& arguments,
                    std::string& problem) {
  const Signature known = signature(parameters);
  std::vector<const Expr*> parts = pointers(call.items);
  parts.erase(parts.begin());
  const std::vector<NodeId> given = operands(parts);
  const std::size_t positional = given.size() - call.keywords.size();
  arguments.assign(known.parameters.size(), kNone);
  std::size_t used = 0;
  for (std::size_t i = 0; i < known.parameters.size() && used < positional; ++i)
    if (known.parameters[i].positional) arguments[i] = given[used++];
  if (used < positional && !known.variadic) problem = "takes fewer arguments";
  arguments.insert(arguments.end(), given.begin() + static_cast<std::ptrdiff_t>(used),
                   given.begin() + static_cast<std::ptrdiff_t>(positional));
  for (std::size_t k = 0; k < call.keywords.size(); ++k) {
    std::size_t i = 0;
    while (i < known.parameters.size() &&
           !(known.parameters[i].by_name && known.parameters[i].name == call.keywords[k]))
      ++i;
    if (i == known.parameters.size()) {
      // Only dict() has names of its own: they follow as pairs.
      arguments.push_back(emit(Op::constant, call.at, name_constant(call.keywords[k])));
      arguments.push_back(given[positional + k]);
    } else if (arguments[i] != kNone) {
      problem = "got multiple values for argument '" + call.keywords[k] + "'";
    } else {
      arguments[i] = given[positional + k];
    }
  }
  for (std::size_t i = 0; i < known.parameters.size(); ++i)
    if (known.parameters[i].required && arguments[i] == kNone) problem = "needs more arguments";
  if (!problem.empty()) arguments = given;
  return problem.empty();
}

NodeId Compiler::method_call(const Expr& e) {
  const Expr& callee = *e.items[0];
  const Expr& object = *callee.items[0];
  const Method& method = *find_method(callee.name);
  MethodCall made;
  made.method = &method;
  const Reference r = resolve(object, program_->kind, symbols_);
  const bool in_place = method.changes() && !root_of(object).empty() &&
                        (r.meaning == Meaning::value || r.meaning == Meaning::other) &&
                        (root_of(object) == "res" || root_of(object) == "var" || !is_reserved(root_of(object)));
  std::vector<NodeId> arguments;
  std::vector<const Expr*> parts = pointers(e.items);
  if (in_place) {
    made.place = place(object, true);
    parts.erase(parts.begin());
    arguments = operands(parts);
  } else {
    parts[0] = &object;
    arguments = operands(parts);
  }
  if (!e.keywords.empty()) {
    // Keywords exist only in methods of one type; put them in their places behind the object.
    const Signature known = signature(method.parameters());
    const std::size_t first = in_place ? 0 : 1;
    const std::size_t positional = arguments.size() - e.keywords.size();
    std::vector<NodeId> ordered(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(positional));
    for (std::size_t k = 0; k < e.keywords.size(); ++k) {
      std::size_t i = 0;
      while (known.parameters[i].name != e.keywords[k]) ++i;
      if (ordered.size() <= first + i) ordered.resize(first + i + 1, kNone);
      if (ordered[first + i] != kNone) {
        return emit_run(Op::wrong_call, e.at, arguments,
                        constant(Value(callee.name + "() got multiple values for argument '" + e.keywords[k] + "'")));
      }
      ordered[first + i] = arguments[positional + k];
    }
    arguments = std::move(ordered);
  }
  program_->methods.push_back(made);
  const auto number = static_cast<std::uint32_t>(program_->methods.size() - 1);
  return emit_run(in_place ? Op::change : method.changes() ? Op::change_value : Op::method, e.at, arguments, number);
}

}  // namespace race::language
