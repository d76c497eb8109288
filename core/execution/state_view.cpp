#include "core/execution/state_view.h"

#include <algorithm>
#include <utility>

namespace race::execution {

using semantics::Program;
using semantics::Run;

namespace {

std::vector<std::uint8_t> port_flags(const Run& run) {
  const auto& flags = run.state().flags;
  return {flags.end() - static_cast<std::ptrdiff_t>(run.program().ports.size()), flags.end()};
}

// dict[key], made if it is not there.
Dict& entry(Dict& dict, const std::string& key) {
  const Value name(key);
  if (!dict.find(name)) dict.set(name, Dict());
  return dict.find(name)->mutable_dict();
}

// Which value it is: field of the delta, path, name.
struct Place {
  const char* field;
  const std::string &path, &name;
};
Place place(const Program& program, semantics::ValueIndex at) {
  const semantics::StateInfo& state = program[program.value_owner[at]];
  if (at - state.first_parameter < state.parameters.size())
    return {"parameters", state.path, state.parameters[at - state.first_parameter].name};
  if (at - state.first_result < state.results.size())
    return {"results", state.path, state.results[at - state.first_result]};
  return {"variables", state.path, state.variables[at - state.first_variable]};
}

}  // namespace

void StateView::remember(const Run& run) {
  flags_ = run.state().flags;
  arrived_ = run.state().arrived;
  values_ = run.state().values;
}

Value StateView::snapshot(const Run& run) {
  remember(run);
  ports_ = port_flags(run);
  fired_.clear();
  return run.state_json();
}

void StateView::note_fired_ports(const Run& run) {
  std::vector<std::uint8_t> now = port_flags(run);
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] && !ports_[i])
      fired_.emplace_back(run.program().address(semantics::PortId{static_cast<std::uint32_t>(i)}));
  ports_ = std::move(now);
}

Dict StateView::delta(const Run& run) {
  Dict out;
  add_flags(run, out);
  add_arrivals(run, out);
  add_values(run, out);
  out.set("fired", std::exchange(fired_, {}));
  remember(run);
  return out;
}

void StateView::add_flags(const Run& run, Dict& out) const {
  const Program& program = run.program();
  const auto& flags = run.state().flags;
  const std::size_t nodes = program.states.size() + program.barriers.size();
  Dict active, ports;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] == flags_[i]) continue;
    if (i < nodes) {
      active.set(program.node_path(static_cast<semantics::Flag>(i)), flags[i] != 0);
    } else {
      ports.set(program.address(semantics::PortId{static_cast<std::uint32_t>(i - nodes)}), flags[i] != 0);
    }
  }
  out.set("active", std::move(active));
  out.set("ports", std::move(ports));
}

void StateView::add_arrivals(const Run& run, Dict& out) const {
  const Program& program = run.program();
  const auto& arrived = run.state().arrived;
  Dict activated;
  for (const semantics::BarrierInfo& barrier : program.barriers) {
    const bool changed = std::ranges::any_of(
        barrier.in, [&](semantics::PortId port) { return arrived[index(port)] != arrived_[index(port)]; });
    if (!changed) continue;
    List ports;
    for (const semantics::PortId port : barrier.in)
      if (arrived[index(port)]) ports.emplace_back(program.address(port));
    activated.set(barrier.path, std::move(ports));
  }
  out.set("activated", std::move(activated));
}

void StateView::add_values(const Run& run, Dict& out) const {
  const auto& values = run.state().values;
  Dict set{{"parameters", Dict()}, {"results", Dict()}, {"variables", Dict()}}, unset;
  for (std::size_t at = 0; at < values.size(); ++at) {
    if (values[at].identical(values_[at])) continue;
    const auto [field, path, name] = place(run.program(), static_cast<semantics::ValueIndex>(at));
    if (!values[at].is_unknown()) {
      entry(entry(set, field), path).set(name, values[at]);
      continue;
    }
    Dict& of_field = entry(unset, field);
    const Value key(path);
    if (!of_field.find(key)) of_field.set(key, List());
    of_field.find(key)->mutable_list().emplace_back(name);
  }
  for (const auto& [field, entries] : set) out.set(field, entries);
  out.set("unset", std::move(unset));
}

}  // namespace race::execution
