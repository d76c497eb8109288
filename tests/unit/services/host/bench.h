// A Bench: a host with one queue and a clock of world time, and what its services said. Tests of components use it in
// place of cores.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "core/rsm/document.h"
#include "services/host/host.h"

namespace race::services {

class Bench final : public HostObserver {
 public:
  explicit Bench(MotionGate* gate = nullptr) : host(clock, *this, gate) {}

  template <typename C, typename... Arguments>
  C& add(const std::string& key, Arguments&&... arguments) {
    ServiceHost& service = host.declare(key, key, queue);
    auto component = std::make_unique<C>(std::forward<Arguments>(arguments)..., service);
    C& made = *component;
    host.attach(key, std::move(component));
    return made;
  }

  /// Calls as core "1" and lets the queue work.
  CallId call(const std::string& service, const std::string& operation, List args = {}, Dict kwargs = {}) {
    const CallId id = host.call({"1", ++calls}, service, operation, std::move(args), std::move(kwargs));
    queue.run();
    return id;
  }

  /// Lets `seconds` pass in steps of 1 ms; time waits for the answers that are due.
  void pass(double seconds) {
    for (auto ms = std::lround(seconds * 1000); ms > 0; --ms) {
      clock.set(static_cast<double>(++milliseconds) / 1000);
      host.advance(true);
      queue.run();
      host.step(queue);
    }
  }

  /// Responses so far as "service.operation -> value" or "!> error code"; events are left out.
  std::vector<std::string> responses() const;
  std::vector<Violation> violations(const std::string& key) const { return host.service(key)->violations; }

  void delivered(const Delivery& delivery) override { deliveries.push_back(delivery); }
  void changed(const ServiceStatus& status) override;
  void logged(Time, const std::string&, const std::string& text) override {
    log.push_back(text);
    if (const auto say = on_log) say();
  }

  WorldClock clock;
  WorkQueue queue;
  std::vector<Delivery> deliveries;
  std::vector<std::string> log;
  std::function<void()> on_log;
  std::uint64_t calls = 0;
  std::vector<std::string> changes;  // of services: "key: STATE by TRANSITION, N pending"
  int milliseconds = 0;
  Host host;
};

/// `tap`: has no operations and offers the flow `water` of drops.
inline const rsm::Service& tap_model() {
  static const rsm::Service model =
      rsm::read_service_text(R"({"rsm": 1, "name": "tap", "states": [{"name": "Open"}], "init": "Open",
                                 "meta": {"flows": {"water": "drops"}}})",
                             "tap")
          .value();
  return model;
}

}  // namespace race::services
