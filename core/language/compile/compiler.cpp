// Compiling: translates the syntax tree to a Program and resolves names. The entry point and the creation of nodes.
#include <algorithm>

#include "core/language/check/checker.h"
#include "core/language/compile/compiler_internal.h"
#include "core/language/compile/condition_analysis_internal.h"
#include "core/language/syntax/parser.h"

namespace race::language {

Compiler::Compiler(std::string_view text, CodeKind kind, const Symbols& symbols, ServiceTable& services)
    : symbols_(symbols), services_(services), program_(std::make_shared<Program>()) {
  program_->kind = kind;
  program_->text = std::string(text);
}

Code Compiler::run(const Tree& tree) {
  if (tree.expression) {
    program_->root = program_->kind == CodeKind::condition ? boolean(*tree.expression) : expression(*tree.expression);
  } else {
    for (const std::string& name : assigned_names(tree.statements)) {
      scope_.emplace_back(name, static_cast<std::uint32_t>(program_->locals.size()));
      program_->locals.push_back(name);
    }
    program_->root = block(tree.statements);
  }
  return finish();
}

NodeId Compiler::emit(Opcode op, Span at, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  Node node;
  node.op = op;
  node.service = service_;
  node.a = a;
  node.b = b;
  node.c = c;
  program_->nodes.push_back(node);
  program_->spans.push_back(at);
  return static_cast<NodeId>(program_->nodes.size() - 1);
}

NodeId Compiler::emit_run(Opcode op, Span at, const std::vector<std::uint32_t>& run, std::uint32_t b, std::uint32_t c) {
  const auto begin = static_cast<std::uint32_t>(program_->runs.size());
  program_->runs.insert(program_->runs.end(), run.begin(), run.end());
  const NodeId id = emit(op, at, begin, b, c);
  program_->nodes[id].count = static_cast<std::uint16_t>(run.size());
  return id;
}

// Compiles parts that are evaluated one after the other. A value that a later part may change is copied.
std::vector<NodeId> Compiler::operands(const std::vector<const Expr*>& parts) {
  std::vector<bool> changes_later(parts.size() + 1, false);
  for (std::size_t i = parts.size(); i-- > 0;)
    changes_later[i] = changes_later[i + 1] || (parts[i] != nullptr && changes(*parts[i]));
  std::vector<NodeId> ids;
  for (std::size_t i = 0; i < parts.size(); ++i)
    ids.push_back(parts[i] == nullptr ? kNone : copied_if(expression(*parts[i]), changes_later[i + 1]));
  return ids;
}

NodeId Compiler::copied_if(NodeId node, bool changes_later) {
  return changes_later ? emit(Opcode::copy, program_->spans[node], node) : node;
}

// Whether evaluating `e` can change a value.
bool Compiler::changes(const Expr& e) {
  if (e.kind == ExprKind::call && e.items[0]->kind == ExprKind::attribute) {
    const Method* method = find_method(e.items[0]->name);
    if (method != nullptr && method->mutates()) return true;
  }
  bool found = false;
  for_each_part(e, [&](const Expr& part) { found = found || changes(part); });
  return found;
}

std::uint32_t Compiler::constant(Value value) {
  if (value.is_string()) {
    const auto known = names_.find(value.as_string());
    if (known != names_.end()) return known->second;
    names_.emplace(value.as_string(), static_cast<std::uint32_t>(program_->constants.size()));
  }
  value.freeze();
  program_->constants.push_back(std::move(value));
  return static_cast<std::uint32_t>(program_->constants.size() - 1);
}

std::uint32_t Compiler::local(std::string_view name) {
  const auto found =
      std::find_if(scope_.rbegin(), scope_.rend(), [&](const auto& entry) { return entry.first == name; });
  return found->second;
}

Code Compiler::finish() {
  const auto list = [](const auto& set) { return std::vector<std::uint32_t>(set.begin(), set.end()); };
  Mentions& m = program_->mentions;
  m.svc = service_ || m.svc;
  m.events = list(events_);
  m.latest = list(latest_);
  m.responses = list(responses_);
  m.calls = list(calls_);
  m.reads = list(reads_);
  m.writes = list(writes_);
  m.flags = list(flags_);
  if (program_->kind == CodeKind::condition) {
    m.needs_occurrence = needs_occurrence(*program_, services_);
    program_->comparison = comparison_of(*program_);
  }
  Code code;
  code.program_ = std::move(program_);
  return code;
}

Checked<Code> compile(std::string_view text, CodeKind kind, const Symbols& symbols, ServiceTable& services) {
  if (std::vector<Error> errors = check(text, kind, symbols); !errors.empty()) return tl::unexpected(std::move(errors));
  for (const std::string& name : variable_names(text))
    if (symbols.variables.find(name) == symbols.variables.end())
      return tl::unexpected(std::vector{Error{ErrorCode::unknown_name, "var." + name + " has no place"}});
  const Parsed parsed = parse(text, kind);
  return Compiler(text, kind, symbols, services).run(parsed.tree);
}

}  // namespace race::language
