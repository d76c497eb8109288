// A lamp: a component with a transition, a deferred answer, an event and flows, for tests of what stands between it and
// its host.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/rsm/document.h"
#include "core/value/json.h"
#include "services/component.h"
#include "services/host/call_ledger.h"

namespace race::remote {

inline const rsm::Service& lamp_model() {
  static const rsm::Service model = rsm::read_service_text(R"json({
    "rsm": 1, "name": "lamp",
    "operations": [{"name": "on"}, {"name": "blink"}, {"name": "burn"}],
    "events": [{"name": "lit", "data": "any"}],
    "subscribes": [{"service": "camera", "event": "images"}],
    "states": [{"name": "Dark"}, {"name": "Bright"}], "init": "Dark",
    "transitions": [{"id": "t1", "src": "Dark", "dst": "Bright", "operation": "on", "events": ["lit"]},
                    {"id": "t2", "src": "Bright", "dst": "Bright", "operation": "blink", "defer": ["t3"]},
                    {"id": "t3", "src": "Bright", "dst": "Dark"}]})json",
                                                           "services/lamp")
                                        .value();
  return model;
}

// `on` is answered at once, `blink` by a test, `burn` never.
class Lamp final : public services::Component {
 public:
  explicit Lamp(services::ServiceHost& its_host) : host(its_host) {}
  const rsm::Service& model() const override { return lamp_model(); }
  void call(const services::Call& call) override {
    calls.push_back(call);
    if (call.operation == "blink") return host.transition("t2", call.id);
    if (call.operation != "on" || bright) return host.reject(call.id);
    bright = true;
    host.transition("t1", call.id);
    host.result(call.id, answer);
    host.event("lit", 1);
  }
  void packet(std::string_view key, std::string_view flow, const services::PacketPtr& packet) override {
    packets.push_back(std::string(key) + "." + std::string(flow) + " at " + to_json(packet->time) + ": " +
                      std::to_string(packet->bytes.size()) + " bytes");
  }
  void demand_changed(std::string_view flow, bool on) override {
    wishes.push_back(std::string(flow) + (on ? " on" : " off"));
  }

  void limit_speed(std::optional<double> tool_speed) override {
    wishes.push_back("at most " + (tool_speed ? to_json(*tool_speed) : "any") + " after " +
                     std::to_string(calls.size()) + " calls");
  }

  void halt() override { ++halts; }
  void violated(const services::Violation& violation) override { violations.push_back(violation); }

  services::ServiceHost& host;
  int halts = 0;
  Value answer;
  bool bright = false;
  std::vector<services::Call> calls;
  std::vector<std::string> packets, wishes;
  std::vector<services::Violation> violations;
};

}  // namespace race::remote
