// Compiles the code of a program that is laid out, and finds who reads what: the states that a change of Δ or an input
// makes dirty (work_set.h).
#include <algorithm>
#include <set>

#include "core/semantics/program_internal.h"
#include "core/semantics/scope.h"
#include "core/value/error_list.h"

namespace race::semantics {
namespace {

using language::CodeKind;
using language::Symbols;

class CodeCompiler {
 public:
  CodeCompiler(Program& program, const std::vector<const rcm::State*>& syntax) : p_(program), syntax_(syntax) {}

  std::vector<Error> build() {
    // svc[expr].x stands for every service of the table, so names that code adds to it have to be there first.
    for (std::size_t known = kNone; known != table_size();) {
      known = table_size();
      prepare_readers();
      for (std::uint32_t s = 0; s < p_.states.size(); ++s) compile(s);
    }
    finish_masks();
    return std::move(errors_);
  }

 private:
  std::size_t table_size() const { return p_.services.events().size() + p_.services.operations().size(); }

  void prepare_readers() {
    errors_.clear();
    p_.value_readers.assign(p_.initial.size(), kNoReader);
    p_.flag_readers.assign(p_.flag_count(), kNoReader);
    masks_.assign(p_.states.size(), 0);
  }

  Code compiled(const std::string& text, CodeKind kind, const Symbols& symbols, const std::string& path) {
    auto code = language::compile(text, kind, symbols, p_.services);
    if (code) return *code;
    for (Error& error : code.error()) {
      error.path = path;
      add_error(errors_, std::move(error));
    }
    return {};
  }

  // What a condition or action of state `number` reads decides when they are evaluated again.
  void add_readers(std::uint32_t number, const Code& code) {
    if (!code) return;
    const language::Mentions& m = code.mentions();
    for (const auto* events : {&m.events, &m.latest})
      for (const EventId e : *events) {
        masks_[number] |= Program::event_bit(e);
        event_readers_[e].insert(StateId{number});
      }
    for (const OperationId o : m.responses) {
      masks_[number] |= Program::response_bit(o);
      response_readers_[o].insert(StateId{number});
    }
    const auto& owner = p_.value_owner;
    for (const ValueIndex at : m.reads) p_.value_readers[at] |= index(owner[at]) == number ? kOwner : kParent;
    for (const Flag flag : m.flags) {
      const bool own = flag >= p_.first_port_flag && index(p_.ports[flag - p_.first_port_flag].state) == number;
      p_.flag_readers[flag] |= own ? kOwner : kParent;
    }
    add_inputs(code);
  }

  // Inputs are what code names, wherever it stands.
  void add_inputs(const Code& code) {
    if (!code) return;
    const language::Mentions& m = code.mentions();
    named_events_.insert(m.events.begin(), m.events.end());
    named_events_.insert(m.latest.begin(), m.latest.end());
    named_responses_.insert(m.responses.begin(), m.responses.end());
  }

  void compile(std::uint32_t number) {
    const rcm::State& syntax = *syntax_[number];
    const Symbols symbols = symbols_of(p_, StateId{number});
    StateInfo& state = p_.states[number];
    std::set<OperationId> calls;
    const auto add_calls = [&](const Code& code) {
      if (code) calls.insert(code.mentions().calls.begin(), code.mentions().calls.end());
    };
    if (syntax.entry) state.entry = compiled(*syntax.entry, CodeKind::function, symbols, state.path);
    if (syntax.exit) state.exit = compiled(*syntax.exit, CodeKind::function, symbols, state.path);
    add_inputs(state.entry);
    add_inputs(state.exit);
    add_calls(state.entry);
    add_calls(state.exit);
    for (std::size_t i = 0; i < syntax.actions.size(); ++i) {
      ActionInfo& action = p_.actions[state.actions.low + i];
      action.when = compiled(syntax.actions[i].when, CodeKind::condition, symbols, state.path);
      action.code = compiled(syntax.actions[i].code, CodeKind::function, symbols, state.path);
      if (!action.when || !action.code) continue;
      const language::Mentions& when = action.when.mentions();
      const language::Mentions& code = action.code.mentions();
      action.served = !when.events.empty() || !when.responses.empty() || !code.events.empty() ||
                      !code.responses.empty() || !code.calls.empty();
      action.level = when.events.empty() && when.responses.empty();
      action.events = action.level ? code.events : when.events;
      action.responses = action.level ? code.responses : when.responses;
      add_readers(number, action.when);
      add_readers(number, action.code);
      add_calls(action.code);
    }
    for (std::size_t i = 0; i < syntax.ports.size(); ++i) {
      PortInfo& port = p_.ports[state.ports.low + i];
      port.when =
          compiled(syntax.ports[i].when.value_or("False"), CodeKind::condition, symbols, state.path + "." + port.name);
      port.svc = port.when && port.when.mentions().svc;
      add_readers(number, port.when);
    }
    for (const NodeRef child : state.children) {
      if (child.barrier) continue;
      const rcm::State& child_syntax = *syntax_[child.number];
      StateInfo& info = p_.states[child.number];
      for (std::size_t i = 0; i < child_syntax.parameters.size(); ++i)
        if (child_syntax.parameters[i].from)
          info.parameters[i].from =
              compiled(*child_syntax.parameters[i].from, CodeKind::expression, symbols, info.path);
    }
    state.calls.assign(calls.begin(), calls.end());
    state.needs_occurrence = syntax.actions.empty();
    for (const PortId p : state.ports)
      state.needs_occurrence = state.needs_occurrence && p_[p].when && p_[p].when.mentions().needs_occurrence;
    state.stateless = state.results.empty() && state.variables.empty() && state.end == number + 1;
  }

  void finish_masks() {
    for (std::uint32_t s = static_cast<std::uint32_t>(p_.states.size()); s-- > 0;) {
      StateInfo& state = p_.states[s];
      state.own_mask = masks_[s];
      state.subtree_mask |= masks_[s];
      if (state.parent != kNoState) {
        StateInfo& parent = p_.states[index(state.parent)];
        parent.subtree_mask |= state.subtree_mask;
        std::vector<OperationId> calls;
        std::ranges::set_union(parent.calls, state.calls, std::back_inserter(calls));
        parent.calls = std::move(calls);
      }
    }
    for (ValueIndex at = 0; at < p_.value_readers.size(); ++at)
      if (p_.value_readers[at] & kParent) p_.states[index(p_.value_owner[at])].read_by_parent = true;
    p_.event_named.assign(p_.services.events().size(), 0);
    p_.response_named.assign(p_.services.operations().size(), 0);
    p_.event_readers.resize(p_.event_named.size());
    p_.response_readers.resize(p_.response_named.size());
    for (const auto& [e, readers] : event_readers_) p_.event_readers[e].assign(readers.begin(), readers.end());
    for (const auto& [o, readers] : response_readers_) p_.response_readers[o].assign(readers.begin(), readers.end());
    for (const EventId e : named_events_) p_.event_named[e] = 1;
    for (const OperationId o : named_responses_) p_.response_named[o] = 1;
    for (const auto& event : p_.services.events()) p_.sampled.push_back(event.sampled ? 1 : 0);
  }

  Program& p_;
  const std::vector<const rcm::State*>& syntax_;  // by state number
  std::vector<std::uint64_t> masks_;
  std::map<EventId, std::set<StateId>> event_readers_;
  std::map<OperationId, std::set<StateId>> response_readers_;
  std::set<EventId> named_events_;
  std::set<OperationId> named_responses_;
  std::vector<Error> errors_;
};

}  // namespace

std::vector<Error> compile_code(Program& program, const std::vector<const rcm::State*>& syntax) {
  return CodeCompiler(program, syntax).build();
}

}  // namespace race::semantics
