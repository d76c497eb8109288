// RemoteComponent: the proxy of a component that lives in another process. It hands calls and packets to that process
// and announces to its ServiceHost what the process announces; it knows nothing of the service itself.
//
// Threads: its group's.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "services/component.h"
#include "services/remote/host_functions.h"
#include "services/remote/protocol.h"
#include "services/remote/send_queue.h"

namespace race::remote {

class RemoteComponent final : public services::Component {
 public:
  /// `model`: the RSM that the process must bring. The host outlives the component.
  RemoteComponent(std::string key, std::shared_ptr<const rsm::Service> model, services::ServiceHost& host,
                  HostFunctions functions = {});

  /// What is sent goes to `process` from now on; nullptr: to nobody. `hears_violations`: it wants to be told what does
  /// not fit its RSM.
  void connect(std::shared_ptr<SendQueue> process, bool hears_violations = false);
  /// The process has announced something or calls a host function. Requires a message of such a kind. Errors: those
  /// of the function.
  Expected<void> announce(Message message);
  /// Sends `news` to the process if something has changed for its host functions.
  void notify_changes();

  const rsm::Service& model() const override { return *model_; }
  void call(const services::Call& call) override;
  void packet(std::string_view key, std::string_view flow, const services::PacketPtr& packet) override;
  void demand_changed(std::string_view flow, bool on) override;
  void limit_speed(std::optional<double> tool_speed) override;
  void violated(const services::Violation& violation) override;

 private:
  Expected<void> send(const Message& message, const std::string& flow = {});
  Expected<void> answer(const Message& request);

  const std::string key_;
  const std::shared_ptr<const rsm::Service> model_;  // held by who declares it too
  services::ServiceHost& host_;
  const HostFunctions functions_;
  std::uint64_t notified_version_ = 0;  // of the host functions, as the process knows it
  std::shared_ptr<SendQueue> process_;  // held by its connection too
  bool hears_violations_ = false;
};

}  // namespace race::remote
