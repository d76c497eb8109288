// The state of a run as core/SEMANTICS.md section 7 shows it.
#include "core/semantics/run.h"

namespace race::semantics {
namespace {

class ObservedState {
 public:
  ObservedState(const Program& program, const RunState& run) : p_(program), r_(run) { node(Program::root); }

  Value value() && {
    Dict out;
    out.set("active", std::move(active_));
    out.set("ports", std::move(ports_));
    out.set("activated", std::move(activated_));
    out.set("parameters", std::move(parameters_));
    out.set("results", std::move(results_));
    out.set("variables", std::move(variables_));
    return out;
  }

 private:
  bool is_on(Flag flag) const { return r_.flags[flag] != 0; }

  void node(StateId s) {
    const StateInfo& info = p_[s];
    if (is_on(p_.flag(s))) active_.emplace_back(info.path);
    for (const PortId port : info.ports)
      if (is_on(p_.flag(port))) ports_.emplace_back(p_.address(port));
    Dict parameters;
    for (std::size_t i = 0; i < info.parameters.size(); ++i)
      add(parameters, info.parameters[i].name, info.first_parameter + static_cast<ValueIndex>(i));
    store(parameters_, info.path, std::move(parameters));
    store(results_, info.path, named(info.results, info.first_result));
    store(variables_, info.path, named(info.variables, info.first_variable));
    for (const NodeRef child : info.children) child.barrier ? barrier(child.as_barrier()) : node(child.state());
  }

  void barrier(BarrierId b) {
    const BarrierInfo& info = p_[b];
    if (is_on(p_.flag(b))) active_.emplace_back(info.path);
    List arrived;
    for (const PortId port : info.in)
      if (r_.arrived[index(port)]) arrived.emplace_back(p_.address(port));
    if (!arrived.empty()) activated_.set(info.path, std::move(arrived));
  }

  void add(Dict& out, const std::string& name, ValueIndex at) const {
    if (!r_.values[at].is_unknown()) out.set(name, r_.values[at]);
  }
  Dict named(const std::vector<std::string>& names, ValueIndex first) const {
    Dict out;
    for (std::size_t i = 0; i < names.size(); ++i) add(out, names[i], first + static_cast<ValueIndex>(i));
    return out;
  }
  static void store(Dict& where, const std::string& path, Dict values) {
    if (!values.empty()) where.set(path, std::move(values));
  }

  const Program& p_;
  const RunState& r_;
  List active_, ports_;
  Dict activated_, parameters_, results_, variables_;
};

}  // namespace

Value Run::state_json() const { return ObservedState(program(), state()).value(); }

}  // namespace race::semantics
