#include "core/semantics/scope.h"

#include <algorithm>

#include "core/language/check/checker.h"

namespace race::semantics {

using language::Symbols;

namespace {

void fill(std::map<std::string, ValueIndex, std::less<>>& places, const std::vector<std::string>& names,
          ValueIndex first) {
  for (const std::string& name : names) places.emplace(name, first++);
}

void fill(std::map<std::string, ValueIndex, std::less<>>& places, const std::vector<ParameterInfo>& parameters,
          ValueIndex first) {
  for (const ParameterInfo& parameter : parameters) places.emplace(parameter.name, first++);
}

void fill(std::map<std::string, Flag, std::less<>>& flags, const Program& program, Range<PortId> ports) {
  for (const PortId port : ports) flags.emplace(program[port].name, program.flag(port));
}

tl::unexpected<std::vector<Error>> unread(const std::string& service, const std::string& name) {
  return tl::unexpected(std::vector<Error>{
      {ErrorCode::unknown_name, "the model reads nothing of `svc." + service + "." + name + "`", {}}});
}

}  // namespace

Symbols symbols_of(const Program& program, StateId s) {
  const StateInfo& state = program[s];
  Symbols symbols;
  fill(symbols.parameters, state.parameters, state.first_parameter);
  fill(symbols.results, state.results, state.first_result);
  fill(symbols.variables, state.variables, state.first_variable);
  fill(symbols.ports, program, state.ports);
  for (const NodeRef child : state.children) {
    language::ChildSymbols entry;
    entry.barrier = child.barrier;
    entry.active = program.flag(child);
    if (child.barrier) {
      symbols.children.emplace(program[child.as_barrier()].name, std::move(entry));
      continue;
    }
    const StateInfo& info = program[child.state()];
    fill(entry.parameters, info.parameters, info.first_parameter);
    fill(entry.results, info.results, info.first_result);
    fill(entry.ports, program, info.ports);
    symbols.children.emplace(info.name, std::move(entry));
  }
  return symbols;
}

Checked<Code> compile_condition(const Program& program, StateId s, std::string_view text) {
  const Symbols symbols = symbols_of(program, s);
  if (auto errors = language::check(text, language::CodeKind::condition, symbols); !errors.empty())
    return tl::unexpected(std::move(errors));
  language::ServiceTable services = program.services;
  auto code = language::compile(text, language::CodeKind::condition, symbols, services);
  if (!code) return code;
  const language::Mentions& mentions = code->mentions();
  for (const auto* events : {&mentions.events, &mentions.latest})
    for (const EventId e : *events)
      if (!program.names_event(e)) return unread(services.events()[e].service, services.events()[e].name);
  for (const OperationId o : mentions.responses)
    if (!program.names_response(o)) return unread(services.operations()[o].service, services.operations()[o].name);
  return code;
}

}  // namespace race::semantics
