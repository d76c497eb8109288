// A host for one component: records its announcements and checks them against its RSM with the monitor.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/rsm/monitor.h"
#include "core/value/json.h"
#include "services/component.h"

namespace race::services {

class Recorder final : public ServiceHost {
 public:
  explicit Recorder(const rsm::Service& model) : monitor_(model) {}

  Time now() const override { return time; }
  void transition(std::string_view id, CallId call) override { note(monitor_.transition(id, call)); }
  void result(CallId call, Value value) override {
    note(monitor_.result(call, value));
    results[call] = std::move(value);
  }
  void error(CallId call, Value value) override {
    note(monitor_.error(call, value));
    errors[call] = std::move(value);
  }
  void reject(CallId call) override {
    note(monitor_.rejected(call));
    errors[call] = Dict{{"code", Value("not_accepted")}};
  }
  void event(std::string_view name, Value data) override {
    note(monitor_.event(name, data));
    ++counts[std::string(name)];
    events[std::string(name)] = std::move(data);
  }
  void publish(std::string_view flow, PacketPtr packet) override {
    packets[std::string(flow)].push_back(std::move(packet));
  }
  void log(std::string text) override { logged.push_back(std::move(text)); }

  /// Calls an operation of `component`; arguments are JSON: a list by position or an object by name. Its call id.
  CallId call(Component& component, const std::string& operation, std::string_view arguments = "[]") {
    Call call{++last_, operation, {}, {}};
    const Value given = parse_json(arguments).value();
    if (given.is_list()) call.args = given.as_list();
    if (given.is_dict()) call.kwargs = given.as_dict();
    hand_over(component, call);
    return call.id;
  }

  /// As call(), with a call as a core would hand it over. Requires an id that was not used.
  void hand_over(Component& component, const Call& call) {
    // Wrong arguments are the caller's violation, not the component's.
    static_cast<void>(monitor_.called(call.id, call.operation, call.args, call.kwargs));
    component.call(call);
  }

  std::string code(CallId call) const {
    const auto found = errors.find(call);
    return found == errors.end() ? "" : found->second.find("code")->as_string();
  }
  bool answered(CallId call) const { return results.contains(call) || errors.contains(call); }
  const std::string& state() const { return monitor_.current(); }

  Time time = 0;
  std::map<CallId, Value> results, errors;
  std::map<std::string, Value> events;  // the last data of each
  std::map<std::string, int> counts;
  std::map<std::string, std::vector<PacketPtr>> packets;
  std::vector<std::string> logged;
  std::vector<std::string> violations;

 private:
  void note(const rsm::Monitor::Violations& found) {
    for (const auto& violation : found) violations.push_back(violation.rule + ": " + violation.message);
  }
  rsm::Monitor monitor_;
  CallId last_ = 0;
};

}  // namespace race::services
