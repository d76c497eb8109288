// Reading Δ and Σ of a checkpoint: names become numbers again. What a name or number cannot be is refused.
#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <unordered_map>

#include "core/semantics/run_checkpoint_internal.h"
#include "core/value/error_list.h"

namespace race::semantics {

std::uint64_t read_number(Fields& fields, std::string_view key, std::uint64_t least, std::uint64_t most,
                          Fields::Need need) {
  const auto number = fields.integer(key, static_cast<std::int64_t>(least), static_cast<std::int64_t>(most), need);
  return number ? static_cast<std::uint64_t>(*number) : least;
}

namespace {

using Errors = std::vector<Error>;
constexpr std::uint64_t kMost = kMostInCheckpoint;
constexpr std::uint64_t kMost32 = std::numeric_limits<std::uint32_t>::max();

std::string below(const std::string& path, std::string_view key) { return path + "/" + std::string(key); }

/// The numbers of the elements of one kind by name.
using Names = std::unordered_map<std::string_view, std::uint32_t>;

class StateReader {
 public:
  StateReader(const Program& program, RunState& run, Errors& errors) : p_(program), r_(run), errors_(errors) {
    for (std::uint32_t s = 0; s < p_.states.size(); ++s) states_.emplace(p_.states[s].path, s);
    for (std::uint32_t b = 0; b < p_.barriers.size(); ++b) barriers_.emplace(p_.barriers[b].path, b);
  }

  void read(Fields& fields, std::uint64_t position) {
    r_.epoch = read_number(fields, "epoch", 1, position + 1, kRequired);
    r_.tick = read_number(fields, "tick", 1, kMost, kRequired);
    r_.call_count = read_number(fields, "call_count", 0, kMost, kRequired);
    r_.started = position > 0;
    if (const Value* occurrence = fields.find("occurrence"))
      read_occurrence(*occurrence, below(fields.path(), "occurrence"));
    each(fields, "events", &StateReader::read_event);
    each(fields, "responses", &StateReader::read_response);
    each(fields, "calls", &StateReader::read_call);
    read_services_called(fields);
    if (const Value* states = fields.find("states")) read_states(*states, below(fields.path(), "states"));
    each(fields, "active_barriers", &StateReader::read_active_barrier);
  }

 private:
  /// Reads the items of the list `key`.
  void each(Fields& fields, std::string_view key, void (StateReader::*read_item)(const Value&, const std::string&)) {
    std::size_t number = 0;
    for (const Value& item : fields.list(key))
      (this->*read_item)(item, below(below(fields.path(), key), std::to_string(number++)));
  }
  /// Reads the entries of the object `key`.
  template <typename ReadEntry>
  void each_entry(Fields& fields, std::string_view key, ReadEntry read_entry) {
    const Value* json = fields.find(key);
    if (!json) return;
    const std::string path = below(fields.path(), key);
    if (!json->is_dict())
      return violation(ErrorCode::type, path, "must be an object, got " + std::string(kind_name(*json)));
    for (const auto& [name, entry] : json->as_dict())
      read_entry(name.as_string(), entry, below(path, name.as_string()));
  }
  void violation(ErrorCode code, const std::string& path, std::string message) {
    add_error(errors_, {code, std::move(message), path});
  }
  void unknown_name(const std::string& path, const std::string& what, std::string_view name) {
    violation(ErrorCode::unknown_name, path, "the model has no " + what + " `" + std::string(name) + "`");
  }
  /// What a value may be; it is frozen, as the checkpoint may be read on other threads.
  std::optional<Value> constant(const Value& json, const std::string& path) {
    if (has_number_out_of_range(json)) {
      violation(ErrorCode::constant, path, "a number is out of the range of a 64-bit integer or a double");
      return std::nullopt;
    }
    Value value = json;
    return value.freeze();
  }

  // ---- Σ

  EventId read_event_name(Fields& fields) {
    const auto service = fields.text("service", kRequired), event = fields.text("event", kRequired);
    if (!service || !event) return kNone;
    const EventId e = p_.services.find_event(*service, *event);
    if (e == kNone || !p_.names_event(e)) return unknown_name(fields.path(), "event", *service + "." + *event), kNone;
    return e;
  }

  void read_occurrence(const Value& json, const std::string& path) {
    Fields fields(json, path, "occurrence", errors_, kByField);
    r_.occurrence = read_event_name(fields);
    fields.close();
  }

  void read_event(const Value& json, const std::string& path) {
    Fields fields(json, path, "event", errors_, kByField);
    const EventId e = read_event_name(fields);
    const std::uint64_t tick = read_number(fields, "tick", 1, r_.tick, kRequired);
    const auto data = fields.constant("data", kRequired);
    fields.close();
    if (e == kNone || !data) return;
    if (r_.event_tick[e] != 0) return violation(ErrorCode::duplicate, path, "the event is there already");
    r_.event_tick[e] = tick;
    r_.event_data[e] = *data;
    r_.event_data[e].freeze();
  }

  OperationId find_open(std::string_view name) const {
    const auto& operations = p_.services.operations();
    const auto found =
        std::ranges::find_if(operations, [&](const auto& each) { return each.open && each.name == name; });
    return found == operations.end() ? kNone : static_cast<OperationId>(found - operations.begin());
  }

  void read_response(const Value& json, const std::string& path) {
    Fields fields(json, path, "response", errors_, kByField);
    const auto service = fields.text("service"), name = fields.text("operation", kRequired);
    const std::uint64_t tick = read_number(fields, "tick", 1, r_.tick, kRequired);
    fields.close();
    if (!name) return;
    const OperationId o = service ? p_.services.find_operation(*service, *name) : find_open(*name);
    if (o == kNone) return unknown_name(path, "operation", *name);
    if (r_.response_tick[o] != 0) return violation(ErrorCode::duplicate, path, "the operation is there already");
    r_.response_tick[o] = tick;
  }

  void read_call(const Value& json, const std::string& path) {
    Fields fields(json, path, "call", errors_, kByField);
    CallRecord record;
    record.number = read_number(fields, "call", 1, std::max<std::uint64_t>(r_.call_count, 1), kRequired);
    const auto caller = fields.text("caller", kRequired), service = fields.text("service", kRequired),
               name = fields.text("operation", kRequired);
    read_answer(fields, record);
    fields.close();
    if (!caller || !service || !name) return;
    const auto state = states_.find(*caller);
    if (state == states_.end()) return unknown_name(below(path, "caller"), "state", *caller);
    record.caller = StateId{state->second};
    const OperationId o = p_.services.dynamic_operation(*service, *name);
    if (o == kNone) return unknown_name(path, "operation", *service + "." + *name);
    if (p_.services.is_open(o)) record.service = *service;
    add_call(o, std::move(record), path);
  }

  void read_answer(Fields& fields, CallRecord& record) {
    const bool is_result = fields.find("result") != nullptr;
    record.is_error = fields.find("error") != nullptr;
    record.answered = is_result || record.is_error;
    if (is_result && record.is_error)
      return fields.violation(ErrorCode::conflict, "a call has either a result or an error");
    if (!record.answered) return;
    record.response = fields.constant(record.is_error ? "error" : "result").value_or(Value());
    record.response.freeze();
  }

  // The latest call of each caller is kept, in order.
  void add_call(OperationId o, CallRecord&& record, const std::string& path) {
    std::vector<CallRecord>& records = r_.calls[o];
    if (record.number > r_.call_count || !numbers_.insert(record.number).second)
      return violation(ErrorCode::out_of_range, below(path, "call"), "there is no other call of this number");
    if (!records.empty() && records.back().number > record.number)
      return violation(ErrorCode::conflict, below(path, "call"), "calls of an operation stand in order");
    if (!callers_.emplace(o, record.caller, record.service).second)
      return violation(ErrorCode::duplicate, path, "a caller has one call of an operation");
    records.push_back(std::move(record));
  }

  void read_services_called(Fields& fields) {
    r_.services_called = fields.texts("services_called");
    std::vector<std::string_view> sorted(r_.services_called.begin(), r_.services_called.end());
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end())
      fields.violation(ErrorCode::duplicate, "a service stands there twice", "services_called");
  }

  // ---- Δ, and the stamps of its elements

  void read_states(const Value& json, const std::string& path) {
    if (!json.is_dict())
      return violation(ErrorCode::type, path, "must be an object, got " + std::string(kind_name(json)));
    for (const auto& [name, state] : json.as_dict()) {
      const auto number = states_.find(name.as_string());
      const std::string place = below(path, name.as_string());
      if (number == states_.end())
        unknown_name(place, "state", name.as_string());
      else
        read_state(state, place, StateId{number->second});
    }
  }

  void read_state(const Value& json, const std::string& path, StateId s) {
    Fields fields(json, path, "state", errors_, kByField);
    const StateInfo& info = p_[s];
    Live& live = r_.live[index(s)];
    set_flag(fields, "active", r_.flags[p_.flag(s)]);
    live.activations = static_cast<std::uint32_t>(read_number(fields, "activations", 0, kMost32));
    live.life =
        fields.find("life") ? static_cast<std::uint32_t>(read_number(fields, "life", 1, kMost32)) : live.activations;
    live.activated_in = read_number(fields, "activated_in", 0, r_.epoch);
    live.activated_at = read_number(fields, "activated_at", 0, r_.tick);
    live.calls_before = read_number(fields, "calls_before", 0, kMost);
    read_left_through(fields, info, live);
    std::vector<std::string> parameters;
    for (const ParameterInfo& parameter : info.parameters) parameters.push_back(parameter.name);
    read_values(fields, "parameters", parameters, info.first_parameter);
    read_values(fields, "results", info.results, info.first_result);
    read_values(fields, "variables", info.variables, info.first_variable);
    read_actions(fields, info);
    each_entry(fields, "ports", [&](const std::string& name, const Value& port, const std::string& place) {
      read_port(port, place, port_named(info, name), name);
    });
    fields.close();
  }

  static void set_flag(Fields& fields, std::string_view key, std::uint8_t& flag) {
    flag = fields.boolean(key).value_or(false) ? 1 : 0;
  }

  PortId port_named(const StateInfo& info, std::string_view name) const {
    for (const PortId p : info.ports)
      if (p_[p].name == name) return p;
    return kNoPort;
  }

  void read_left_through(Fields& fields, const StateInfo& info, Live& live) {
    const auto name = fields.text("left_through");
    live.left_during = static_cast<std::uint32_t>(read_number(fields, "left_during", 0, kMost32));
    if (!name) return;
    live.left_through = port_named(info, *name);
    if (live.left_through == kNoPort) unknown_name(below(fields.path(), "left_through"), "port", *name);
  }

  void read_values(Fields& fields, std::string_view key, const std::vector<std::string>& names, ValueIndex first) {
    each_entry(fields, key, [&](const std::string& name, const Value& json, const std::string& path) {
      const auto found = std::ranges::find(names, name);
      if (found == names.end()) return unknown_name(path, "value", name);
      if (auto value = constant(json, path))
        r_.values[first + static_cast<ValueIndex>(found - names.begin())] = std::move(*value);
    });
  }

  void read_actions(Fields& fields, const StateInfo& info) {
    std::size_t number = 0;
    for (const Value& json : fields.list("actions")) {
      const std::string path = below(below(fields.path(), "actions"), std::to_string(number++));
      Fields action(json, path, "action", errors_, kByField);
      const std::uint64_t which = read_number(action, "action", 0, kMost, kRequired),
                          executed = read_number(action, "executed", 0, r_.epoch),
                          served = read_number(action, "served", 0, r_.tick);
      if (executed == 0 && served == 0)
        action.violation(ErrorCode::missing, "an action has been executed or served", "executed");
      action.close();
      if (which >= info.actions.size()) {
        unknown_name(below(path, "action"), "action", std::to_string(which));
        continue;
      }
      const ActionId a = info.actions.low + static_cast<ActionId>(which);
      if (r_.executed[a] != 0 || r_.served[a] != 0)
        violation(ErrorCode::duplicate, path, "the action is there already");
      r_.executed[a] = executed;
      r_.served[a] = served;
    }
  }

  void read_port(const Value& json, const std::string& path, PortId p, const std::string& name) {
    if (p == kNoPort) return unknown_name(path, "port", name);
    Fields fields(json, path, "port", errors_, kByField);
    set_flag(fields, "active", r_.flags[p_.flag(p)]);
    set_flag(fields, "arrived", r_.arrived[index(p)]);
    r_.triggered[index(p)] = read_number(fields, "triggered", 0, r_.epoch);
    fields.close();
  }

  void read_active_barrier(const Value& json, const std::string& path) {
    if (!json.is_string())
      return violation(ErrorCode::type, path, "must be a string, got " + std::string(kind_name(json)));
    const auto number = barriers_.find(json.as_string());
    if (number == barriers_.end()) return unknown_name(path, "barrier", json.as_string());
    std::uint8_t& flag = r_.flags[p_.flag(BarrierId{number->second})];
    if (flag) violation(ErrorCode::duplicate, path, "the barrier is there already");
    flag = 1;
  }

  const Program& p_;
  RunState& r_;
  Errors& errors_;
  Names states_, barriers_;          // by path
  std::set<std::uint64_t> numbers_;  // of calls
  std::set<std::tuple<OperationId, StateId, std::string>> callers_;
};

}  // namespace

void read_run_state(Fields& fields, const Program& program, std::uint64_t position, RunState& run,
                    std::vector<Error>& errors) {
  StateReader(program, run, errors).read(fields, position);
}

}  // namespace race::semantics
