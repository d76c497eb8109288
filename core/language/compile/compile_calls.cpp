// Compiling calls: functions and methods, their arguments in the order of the parameters.
#include <algorithm>

#include "core/language/compile/compiler_internal.h"

namespace race::language {

NodeId Compiler::call(const Expr& e) {
  const Expr& callee = *e.items[0];
  const Path path = path_of(callee);
  if (callee.kind == ExprKind::name && callee.name == "available" && e.items.size() == 2 && e.keywords.empty()) {
    const NodeId operand = boolean(*e.items[1]);
    return emit(Opcode::available, e.at, operand);
  }
  if (callee.kind == ExprKind::name && callee.name == "available") {
    const std::vector<const Expr*> arguments = pointers(e.items);
    return emit_run(Opcode::invalid_call, e.at, operands({arguments.begin() + 1, arguments.end()}),
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
    return emit_run(Opcode::invalid_call, e.at, arguments, constant(Value(std::string(name) + "() " + problem)));
  program_->functions.push_back(&function);
  return emit_run(Opcode::function, e.at, arguments, static_cast<std::uint32_t>(program_->functions.size() - 1));
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
      // Only dict() takes any keywords: they follow as pairs.
      arguments.push_back(emit(Opcode::constant, call.at, name_constant(call.keywords[k])));
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
  const bool in_place = method.mutates() && !root_of(object).empty() &&
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
    // Keywords exist only in methods of one type; put them into the order of its parameters, after the object.
    const Signature known = signature(method.parameters());
    const std::size_t first = in_place ? 0 : 1;
    const std::size_t positional = arguments.size() - e.keywords.size();
    std::vector<NodeId> ordered(arguments.begin(), arguments.begin() + static_cast<std::ptrdiff_t>(positional));
    for (std::size_t k = 0; k < e.keywords.size(); ++k) {
      std::size_t i = 0;
      while (known.parameters[i].name != e.keywords[k]) ++i;
      if (ordered.size() <= first + i) ordered.resize(first + i + 1, kNone);
      if (ordered[first + i] != kNone) {
        return emit_run(Opcode::invalid_call, e.at, arguments,
                        constant(Value(callee.name + "() got multiple values for argument '" + e.keywords[k] + "'")));
      }
      ordered[first + i] = arguments[positional + k];
    }
    arguments = std::move(ordered);
  }
  program_->methods.push_back(made);
  const auto number = static_cast<std::uint32_t>(program_->methods.size() - 1);
  return emit_run(in_place           ? Opcode::mutate
                  : method.mutates() ? Opcode::mutate_temporary
                                     : Opcode::method,
                  e.at, arguments, number);
}

}  // namespace race::language
