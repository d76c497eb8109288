// CorePublisher: what cores report goes to their channels, to the log, and to the operator.
//
// Threads: any, after connect() and set_operator().
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "server/cell/operator.h"
#include "server/execution/cores.h"
#include "server/log/event_log.h"
#include "server/stream/hub.h"

namespace race::server {

class CorePublisher final : public CoreWatcher {
 public:
  /// Both outlive this.
  CorePublisher(Hub& hub, EventLog& log) : hub_(hub), log_(log) {}

  /// To be called once, before the first core is created. Both outlive the cores.
  void connect(const services::Clock& clock, const Cores& cores);
  /// The operator begins anew with each run that is started, and sees its states.
  void set_operator(Operator& person) { operator_ = &person; }

  /// `changed` hears of each change of a core as the list of cores does (schemas/core.json), null: it was removed. On
  /// any thread; must be quick. To be set before the first core is created.
  void on_change(std::function<void(const std::string& id, const Value& core)> changed) {
    changed_ = std::move(changed);
  }

  void core_changed(const std::string& id, Value core) override;
  void core_removed(const std::string& id) override;
  void state_snapshot(const std::string& id, Value state) override;
  void state_replaced(const std::string& id, Value state) override;
  void state_changed(const std::string& id, Value delta) override;
  void derivation_snapshot(const std::string& id, Value next) override;
  void derived(const std::string& id, Value steps) override;
  void printed(const std::string& id, const std::string& text) override;
  void run_lost(const std::string& id, const std::string& why) override;

 private:
  Hub& hub_;
  EventLog& log_;
  const services::Clock* clock_ = nullptr;
  const Cores* cores_ = nullptr;
  Operator* operator_ = nullptr;
  std::function<void(const std::string&, const Value&)> changed_ = [](const std::string&, const Value&) {};
};

}  // namespace race::server
