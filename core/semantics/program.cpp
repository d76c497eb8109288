#include "core/semantics/program.h"

#include <algorithm>
#include <set>

#include "core/language/check/checker.h"

namespace race::semantics {
namespace {

using language::CodeKind;
using language::Symbols;

// Lays a native model out: first the numbers of all elements and their places in Δ, then the code, which needs them.
class Builder {
 public:
  Builder(Program& program, const rcm::NativeModel& model) : p_(program), model_(model) {}

  std::vector<Error> build() {
    lay_out(model_.root, model_.root.name, kNoState);
    p_.first_barrier_flag = static_cast<Flag>(p_.states.size());
    p_.first_port_flag = p_.first_barrier_flag + static_cast<Flag>(p_.barriers.size());
    for (std::uint32_t s = 0; s < p_.states.size(); ++s) connect(s);
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
  Slot place(const std::optional<Value>& initial, StateId owner) {
    p_.initial.push_back(initial ? *initial : Value::unknown());
    p_.initial.back().freeze();
    p_.slot_state.push_back(owner);
    return static_cast<Slot>(p_.initial.size() - 1);
  }

  // Numbers `state`, its ports, actions and values, then its children.
  void lay_out(const rcm::State& state, const std::string& path, StateId parent) {
    const auto number = static_cast<std::uint32_t>(p_.states.size());
    const StateId id{number};
    p_.states.emplace_back();
    syntax_.push_back(&state);
    StateInfo info;
    info.name = state.name;
    info.path = path;
    info.parent = parent;

    info.ports.low = static_cast<std::uint32_t>(p_.ports.size());
    for (const rcm::Port& port : state.ports) {
      PortInfo port_info;
      port_info.name = port.name;
      port_info.state = id;
      p_.ports.push_back(std::move(port_info));
    }
    info.ports.high = static_cast<std::uint32_t>(p_.ports.size());
    info.actions.low = static_cast<std::uint32_t>(p_.actions.size());
    p_.actions.resize(p_.actions.size() + state.actions.size());
    info.actions.high = static_cast<std::uint32_t>(p_.actions.size());

    info.parameter_slot = static_cast<Slot>(p_.initial.size());
    for (const rcm::Parameter& parameter : state.parameters) {
      ParameterInfo parameter_info{parameter.name, parameter.value, {}};
      if (parameter_info.value) parameter_info.value->freeze();
      info.parameters.push_back(std::move(parameter_info));
      place(std::nullopt, id);
    }
    info.result_slot = static_cast<Slot>(p_.initial.size());
    for (const rcm::Datum& result : state.results) {
      info.results.push_back(result.name);
      place(result.initial, id);
    }
    info.variable_slot = static_cast<Slot>(p_.initial.size());
    std::set<std::string> declared;
    for (const rcm::Datum& variable : state.variables) {
      info.variables.push_back(variable.name);
      declared.insert(variable.name);
      place(variable.initial, id);
    }
    for (const std::string& name : used_variables(state)) {  // var.x may be used undeclared
      if (!declared.insert(name).second) continue;
      info.variables.push_back(name);
      place(std::nullopt, id);
    }

    for (const rcm::Node& node : state.children) {
      if (const auto* barrier = std::get_if<rcm::Barrier>(&node)) {
        info.children.push_back({true, static_cast<std::uint32_t>(p_.barriers.size())});
        BarrierInfo barrier_info;
        barrier_info.name = barrier->name;
        barrier_info.path = path + "/" + barrier->name;
        barrier_info.parent = id;
        p_.barriers.push_back(std::move(barrier_info));
      } else {
        const auto& child = std::get<rcm::State>(node);
        info.children.push_back({false, static_cast<std::uint32_t>(p_.states.size())});
        lay_out(child, path + "/" + child.name, id);
      }
    }
    info.end = static_cast<std::uint32_t>(p_.states.size());
    p_.states[number] = std::move(info);
  }

  static std::vector<std::string> used_variables(const rcm::State& state) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& text) {
      for (std::string& name : language::variable_names(text)) names.push_back(std::move(name));
    };
    if (state.entry) add(*state.entry);
    if (state.exit) add(*state.exit);
    for (const rcm::Action& action : state.actions) {
      add(action.when);
      add(action.code);
    }
    for (const rcm::Port& port : state.ports)
      if (port.when) add(*port.when);
    for (const rcm::Node& node : state.children)
      if (const auto* child = std::get_if<rcm::State>(&node))
        for (const rcm::Parameter& parameter : child->parameters)
          if (parameter.from) add(*parameter.from);
    return names;
  }

  NodeRef child_named(StateId parent, const std::string& name) const {
    for (const NodeRef child : p_[parent].children)
      if ((child.barrier ? p_[child.as_barrier()].name : p_[child.state()].name) == name) return child;
    return {};
  }

  // Destinations, first, barriers, keep: names to numbers.
  void connect(std::uint32_t number) {
    const rcm::State& syntax = *syntax_[number];
    StateInfo& state = p_.states[number];
    if (syntax.first) state.first = child_named(StateId{number}, *syntax.first);
    for (std::size_t i = 0; i < syntax.ports.size(); ++i) {
      const PortId port{state.ports.low + static_cast<std::uint32_t>(i)};
      if (!syntax.ports[i].to || state.parent == kNoState) continue;
      const NodeRef to = child_named(state.parent, *syntax.ports[i].to);
      p_.ports[index(port)].to = to;
      if (to.barrier) p_.barriers[to.number].in.push_back(port);
    }
    std::size_t child = 0;
    for (const rcm::Node& node : syntax.children) {
      if (const auto* barrier = std::get_if<rcm::Barrier>(&node))
        for (const std::string& to : barrier->to)
          p_.barriers[state.children[child].number].to.push_back(child_named(StateId{number}, to).state());
      ++child;
    }
    if (syntax.keep) {
      state.keeps = true;
      state.keeps_any = syntax.keep->any;
      for (const PortId port : state.ports)
        if (std::ranges::find(syntax.keep->ports, p_[port].name) != syntax.keep->ports.end())
          state.keep_ports.push_back(port);
    }
  }

  std::size_t table_size() const { return p_.services.events().size() + p_.services.operations().size(); }

  void prepare_readers() {
    errors_.clear();
    p_.slot_readers.assign(p_.initial.size(), kNobody);
    p_.flag_readers.assign(p_.flag_count(), kNobody);
    masks_.assign(p_.states.size(), 0);
  }

  static void fill(std::map<std::string, Slot, std::less<>>& places, const std::vector<std::string>& names,
                   Slot first) {
    for (const std::string& name : names) places.emplace(name, first++);
  }

  Symbols symbols_of(std::uint32_t number) const {
    const StateInfo& state = p_.states[number];
    Symbols symbols;
    Slot slot = state.parameter_slot;
    for (const ParameterInfo& parameter : state.parameters) symbols.parameters.emplace(parameter.name, slot++);
    fill(symbols.results, state.results, state.result_slot);
    fill(symbols.variables, state.variables, state.variable_slot);
    for (const PortId port : state.ports) symbols.ports.emplace(p_[port].name, p_.flag(port));
    for (const NodeRef child : state.children) {
      language::ChildSymbols entry;
      entry.barrier = child.barrier;
      if (child.barrier) {
        entry.active = p_.flag(child.as_barrier());
        symbols.children.emplace(p_[child.as_barrier()].name, std::move(entry));
        continue;
      }
      const StateInfo& info = p_[child.state()];
      entry.active = p_.flag(child.state());
      Slot at = info.parameter_slot;
      for (const ParameterInfo& parameter : info.parameters) entry.parameters.emplace(parameter.name, at++);
      fill(entry.results, info.results, info.result_slot);
      for (const PortId port : info.ports) entry.ports.emplace(p_[port].name, p_.flag(port));
      symbols.children.emplace(info.name, std::move(entry));
    }
    return symbols;
  }

  Code compiled(const std::string& text, CodeKind kind, const Symbols& symbols, const std::string& path) {
    auto code = language::compile(text, kind, symbols, p_.services);
    if (code) return *code;
    for (Error& error : code.error()) {
      error.path = path;
      errors_.push_back(std::move(error));
    }
    return {};
  }

  // What a condition or action of state `number` reads decides when the state looks again.
  void watch(std::uint32_t number, const Code& code) {
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
    const auto& owner = p_.slot_state;
    for (const Slot slot : m.reads) p_.slot_readers[slot] |= index(owner[slot]) == number ? kOwner : kParent;
    for (const Flag flag : m.flags) {
      const bool own = flag >= p_.first_port_flag && index(p_.ports[flag - p_.first_port_flag].state) == number;
      p_.flag_readers[flag] |= own ? kOwner : kParent;
    }
    note(code);
  }

  // Inputs are what code names, wherever it stands.
  void note(const Code& code) {
    if (!code) return;
    const language::Mentions& m = code.mentions();
    named_events_.insert(m.events.begin(), m.events.end());
    named_events_.insert(m.latest.begin(), m.latest.end());
    named_responses_.insert(m.responses.begin(), m.responses.end());
  }

  void compile(std::uint32_t number) {
    const rcm::State& syntax = *syntax_[number];
    const Symbols symbols = symbols_of(number);
    StateInfo& state = p_.states[number];
    std::set<OperationId> calls;
    const auto add_calls = [&](const Code& code) {
      if (code) calls.insert(code.mentions().calls.begin(), code.mentions().calls.end());
    };
    if (syntax.entry) state.entry = compiled(*syntax.entry, CodeKind::function, symbols, state.path);
    if (syntax.exit) state.exit = compiled(*syntax.exit, CodeKind::function, symbols, state.path);
    note(state.entry);
    note(state.exit);
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
      watch(number, action.when);
      watch(number, action.code);
      add_calls(action.code);
    }
    for (std::size_t i = 0; i < syntax.ports.size(); ++i) {
      PortInfo& port = p_.ports[state.ports.low + i];
      port.when =
          compiled(syntax.ports[i].when.value_or("False"), CodeKind::condition, symbols, state.path + "." + port.name);
      port.svc = port.when && port.when.mentions().svc;
      watch(number, port.when);
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
    state.waits = syntax.actions.empty();
    for (const PortId p : state.ports)
      state.waits = state.waits && p_[p].when && p_[p].when.mentions().needs_occurrence;
    state.bare = state.results.empty() && state.variables.empty() && state.end == number + 1;
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
    for (Slot slot = 0; slot < p_.slot_readers.size(); ++slot)
      if (p_.slot_readers[slot] & kParent) p_.states[index(p_.slot_state[slot])].watched = true;
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
  const rcm::NativeModel& model_;
  std::vector<const rcm::State*> syntax_;  // by state number
  std::vector<std::uint64_t> masks_;
  std::map<EventId, std::set<StateId>> event_readers_;
  std::map<OperationId, std::set<StateId>> response_readers_;
  std::set<EventId> named_events_;
  std::set<OperationId> named_responses_;
  std::vector<Error> errors_;
};

}  // namespace

Checked<std::shared_ptr<const Program>> Program::build(const rcm::NativeModel& model,
                                                       const std::map<std::string, rsm::Service>& services) {
  auto program = std::make_shared<Program>();
  for (const auto& [key, service] : services) {
    for (const rsm::Event& event : service.events) program->services.declare_event(key, event.name, event.sampled);
    for (const rsm::Operation& operation : service.operations)
      program->services.declare_operation(key, operation.name, operation.safe);
  }
  std::vector<Error> errors = Builder(*program, model).build();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return std::shared_ptr<const Program>(std::move(program));
}

std::optional<StateId> Program::find_state(std::string_view path) const {
  for (std::uint32_t s = 0; s < states.size(); ++s)
    if (states[s].path == path) return StateId{s};
  return std::nullopt;
}

std::optional<PortId> Program::find_port(std::string_view address) const {
  const auto dot = address.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const auto state = find_state(address.substr(0, dot));
  if (!state) return std::nullopt;
  for (const PortId port : (*this)[*state].ports)
    if ((*this)[port].name == address.substr(dot + 1)) return port;
  return std::nullopt;
}

}  // namespace race::semantics
