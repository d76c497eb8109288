// Lays a native model out: the numbers of its elements in tree order and the places of their values in Δ; then what
// names refer to. program_code.cpp compiles the code, which needs all of this.
#include <algorithm>
#include <set>

#include "core/rcm/used_variables.h"
#include "core/semantics/program_internal.h"

namespace race::semantics {
namespace {

class Layout {
 public:
  Layout(Program& program, const rcm::NativeModel& model) : p_(program), model_(model) {}

  std::vector<const rcm::State*> build() {
    lay_out(model_.root, model_.root.name, kNoState);
    p_.first_barrier_flag = static_cast<Flag>(p_.states.size());
    p_.first_port_flag = p_.first_barrier_flag + static_cast<Flag>(p_.barriers.size());
    for (std::uint32_t s = 0; s < p_.states.size(); ++s) connect(s);
    for (IdIndex* ids : {&p_.ids.states, &p_.ids.barriers, &p_.ids.ports, &p_.ids.actions, &p_.ids.values})
      ids->finish();
    return std::move(syntax_);
  }

 private:
  ValueIndex place(const std::optional<Value>& initial, StateId owner, const std::string& id) {
    p_.ids.values.add(id);
    p_.initial.push_back(initial ? *initial : Value::unknown());
    p_.initial.back().freeze();
    p_.initial_units.push_back(data_units(p_.initial.back()));
    p_.value_owner.push_back(owner);
    return static_cast<ValueIndex>(p_.initial.size() - 1);
  }

  // Numbers `state`, its ports, actions and values, then its children.
  void lay_out(const rcm::State& state, const std::string& path, StateId parent) {
    const auto number = static_cast<std::uint32_t>(p_.states.size());
    const StateId id{number};
    p_.states.emplace_back();
    p_.ids.states.add(state.meta.id);
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
      p_.ids.ports.add(port.meta.id);
    }
    info.ports.high = static_cast<std::uint32_t>(p_.ports.size());
    info.actions.low = static_cast<std::uint32_t>(p_.actions.size());
    p_.actions.resize(p_.actions.size() + state.actions.size());
    for (const rcm::Action& action : state.actions) p_.ids.actions.add(action.meta.id);
    info.actions.high = static_cast<std::uint32_t>(p_.actions.size());

    info.first_parameter = static_cast<ValueIndex>(p_.initial.size());
    for (const rcm::Parameter& parameter : state.parameters) {
      ParameterInfo parameter_info{parameter.name, parameter.value, {}};
      if (parameter_info.value) parameter_info.value->freeze();
      info.parameters.push_back(std::move(parameter_info));
      place(std::nullopt, id, parameter.meta.id);
    }
    info.first_result = static_cast<ValueIndex>(p_.initial.size());
    for (const rcm::Datum& result : state.results) {
      info.results.push_back(result.name);
      place(result.initial, id, result.meta.id);
    }
    info.first_variable = static_cast<ValueIndex>(p_.initial.size());
    std::set<std::string> declared;
    for (const rcm::Datum& variable : state.variables) {
      info.variables.push_back(variable.name);
      declared.insert(variable.name);
      place(variable.initial, id, variable.meta.id);
    }
    for (const std::string& name : rcm::used_variables(state)) {  // var.x may be used undeclared
      if (!declared.insert(name).second) continue;
      info.variables.push_back(name);
      place(std::nullopt, id, "");
    }

    for (const rcm::Node& node : state.children) {
      if (const auto* barrier = std::get_if<rcm::Barrier>(&node)) {
        info.children.push_back({true, static_cast<std::uint32_t>(p_.barriers.size())});
        BarrierInfo barrier_info;
        barrier_info.name = barrier->name;
        barrier_info.path = path + "/" + barrier->name;
        barrier_info.parent = id;
        p_.barriers.push_back(std::move(barrier_info));
        p_.ids.barriers.add(barrier->meta.id);
      } else {
        const auto& child = std::get<rcm::State>(node);
        info.children.push_back({false, static_cast<std::uint32_t>(p_.states.size())});
        lay_out(child, path + "/" + child.name, id);
      }
    }
    info.end = static_cast<std::uint32_t>(p_.states.size());
    p_.states[number] = std::move(info);
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
      state.keeps_deep = syntax.keep->deep;
      for (const PortId port : state.ports)
        if (std::ranges::find(syntax.keep->ports, p_[port].name) != syntax.keep->ports.end())
          state.keep_ports.push_back(port);
    }
  }

  Program& p_;
  const rcm::NativeModel& model_;
  std::vector<const rcm::State*> syntax_;  // by state number
};

}  // namespace

std::vector<const rcm::State*> lay_out(Program& program, const rcm::NativeModel& model) {
  return Layout(program, model).build();
}

}  // namespace race::semantics
