// A run between macro steps as JSON (schemas/checkpoint.json): what a new run has not, by names.
#include "core/semantics/run_internal.h"

namespace race::semantics {
namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

void set_number(Dict& out, const char* key, std::uint64_t n) {
  if (n != 0) out.set(key, integer(n));
}
template <typename Some>
void set_some(Dict& out, std::string_view key, Some some) {
  if (!some.empty()) out.set(key, std::move(some));
}

class StateWriter {
 public:
  StateWriter(const Program& program, const RunState& run) : p_(program), r_(run) {}

  void write(Dict& out) const {
    out.set("epoch", integer(r_.epoch));
    out.set("tick", integer(r_.tick));
    out.set("call_count", integer(r_.call_count));
    if (r_.occurrence != kNone) out.set("occurrence", event_name(r_.occurrence));
    set_some(out, "events", events());
    set_some(out, "responses", responses());
    set_some(out, "calls", calls());
    set_some(out, "services_called", List(r_.services_called.begin(), r_.services_called.end()));
    Dict states;
    for (std::uint32_t s = 0; s < p_.states.size(); ++s) set_some(states, p_.states[s].path, state(StateId{s}));
    set_some(out, "states", std::move(states));
    set_some(out, "active_barriers", active_barriers());
  }

 private:
  bool is_on(Flag flag) const { return r_.flags[flag] != 0; }

  // ---- Σ

  Dict event_name(EventId e) const {
    return {{"service", p_.services.events()[e].service}, {"event", p_.services.events()[e].name}};
  }

  List events() const {
    List out;
    for (EventId e = 0; e < r_.event_tick.size(); ++e) {
      if (r_.event_tick[e] == 0) continue;
      Dict event = event_name(e);
      event.set("tick", integer(r_.event_tick[e]));
      event.set("data", r_.event_data[e]);
      out.emplace_back(std::move(event));
    }
    return out;
  }

  // An open operation has no service.
  List responses() const {
    List out;
    for (OperationId o = 0; o < r_.response_tick.size(); ++o) {
      if (r_.response_tick[o] == 0) continue;
      Dict response;
      if (!p_.services.is_open(o)) response.set("service", p_.services.operations()[o].service);
      response.set("operation", p_.services.operations()[o].name);
      response.set("tick", integer(r_.response_tick[o]));
      out.emplace_back(std::move(response));
    }
    return out;
  }

  List calls() const {
    List out;
    for (OperationId o = 0; o < r_.calls.size(); ++o)
      for (const CallRecord& record : r_.calls[o]) out.emplace_back(call(o, record));
    return out;
  }

  Dict call(OperationId o, const CallRecord& record) const {
    const auto& operation = p_.services.operations()[o];
    Dict out{{"call", integer(record.number)},
             {"caller", p_[record.caller].path},
             {"service", operation.open ? record.service : operation.service},
             {"operation", operation.name}};
    if (record.answered) out.set(record.is_error ? "error" : "result", record.response);
    return out;
  }

  // ---- Δ, and the stamps of its elements

  Dict state(StateId s) const {
    const StateInfo& info = p_[s];
    const Live& live = r_.live[index(s)];
    Dict out;
    if (is_on(p_.flag(s))) out.set("active", true);
    set_number(out, "activations", live.activations);
    set_number(out, "activated_in", live.activated_in);
    set_number(out, "activated_at", live.activated_at);
    set_number(out, "calls_before", live.calls_before);
    if (live.life != live.activations) out.set("life", integer(live.life));
    if (live.left_through != kNoPort) out.set("left_through", p_[live.left_through].name);
    set_number(out, "left_during", live.left_during);
    std::vector<std::string> parameters;
    for (const ParameterInfo& parameter : info.parameters) parameters.push_back(parameter.name);
    set_some(out, "parameters", values(parameters, info.first_parameter));
    set_some(out, "results", values(info.results, info.first_result));
    set_some(out, "variables", values(info.variables, info.first_variable));
    set_some(out, "actions", actions(info));
    Dict ports;
    for (const PortId p : info.ports) set_some(ports, p_[p].name, port(p));
    set_some(out, "ports", std::move(ports));
    return out;
  }

  // Those that have another value than a new run. A value that is set stays set, or becomes the initial one again.
  Dict values(const std::vector<std::string>& names, ValueIndex at) const {
    Dict out;
    for (const std::string& name : names) {
      if (!(r_.values[at] == p_.initial[at])) out.set(name, r_.values[at]);
      ++at;
    }
    return out;
  }

  List actions(const StateInfo& info) const {
    List out;
    for (const ActionId a : info.actions) {
      if (r_.executed[a] == 0 && r_.served[a] == 0) continue;
      Dict action{{"action", integer(a - info.actions.low)}};
      set_number(action, "executed", r_.executed[a]);
      set_number(action, "served", r_.served[a]);
      out.emplace_back(std::move(action));
    }
    return out;
  }

  Dict port(PortId p) const {
    Dict out;
    if (is_on(p_.flag(p))) out.set("active", true);
    if (r_.arrived[index(p)]) out.set("arrived", true);
    set_number(out, "triggered", r_.triggered[index(p)]);
    return out;
  }

  List active_barriers() const {
    List out;
    for (std::uint32_t b = 0; b < p_.barriers.size(); ++b)
      if (is_on(p_.flag(BarrierId{b}))) out.emplace_back(p_.barriers[b].path);
    return out;
  }

  const Program& p_;
  const RunState& r_;
};

Dict fault_json(const RunFault& fault) {
  Dict out{{"kind", language::name(fault.kind)}, {"at", fault.at}, {"message", fault.message}};
  const SourceRange& where = fault.where;
  if (where != SourceRange{}) out.set("where", List{where.line, where.column, where.end_line, where.end_column});
  return out;
}

}  // namespace

Value Run::checkpoint_json() const {
  Dict out{{"position", integer(body_->position)}, {"status", name(body_->status)}};
  if (body_->fault) out.set("fault", fault_json(*body_->fault));
  StateWriter(*body_->program, body_->state).write(out);
  return out;
}

}  // namespace race::semantics
