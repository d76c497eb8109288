// ServicePublisher: what services report goes to the cores, to the operator, to the channel `services` and to the log.
//
// Threads: any, after connect() and set_operator().
#pragma once

#include <string>

#include "server/cell/operator.h"
#include "server/control/manual_control.h"
#include "server/execution/cores.h"
#include "server/log/event_log.h"
#include "server/stream/hub.h"
#include "services/host/host.h"

namespace race::server {

class ServicePublisher final : public services::HostObserver {
 public:
  /// Both outlive this.
  ServicePublisher(Hub& hub, EventLog& log) : hub_(hub), log_(log) {}

  /// To be called once, before the first core is created; outlives the host's deliveries.
  void connect(Cores& cores) { cores_ = &cores; }
  void set_operator(Operator& person) { operator_ = &person; }
  /// Gets the responses to calls by hand.
  void set_manual_control(ManualControl& manual) { manual_ = &manual; }

  void delivered(const services::Delivery& delivery) override;
  void changed(const services::ServiceStatus& status) override;
  void redescribed() override;
  void logged(services::Time time, const std::string& key, const std::string& text) override;

 private:
  Hub& hub_;
  EventLog& log_;
  Cores* cores_ = nullptr;
  Operator* operator_ = nullptr;
  ManualControl* manual_ = nullptr;
};

}  // namespace race::server
