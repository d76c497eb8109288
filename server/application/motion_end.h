// MotionEnd: the cell at the end of the server: from then on no motion begins, no run goes on, and what moves is told
// to stop by the safe operations of its services, while the server still hears that it does.
//
// It latches nothing that a later server would find, unlike a stop of the cell (server/control).
//
// Threads: any.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "server/threads/strand.h"
#include "services/host/motion_gate.h"

namespace race::services {
class Host;
}

namespace race::server {

class Cores;

class MotionEnd final : public services::MotionGate {
 public:
  /// For what is called to reach the services, which nobody sees; for them to answer; then, if something was moving,
  /// for it to brake.
  static constexpr std::chrono::milliseconds kArrival{100}, kAnswerTimeout{1000}, kBraking{500};
  /// What was set in motion may be in motion for so long though its call was answered: of an operation that is called
  /// while a person holds a button.
  static constexpr std::chrono::seconds kLastMotion{1};

  /// What lets motions begin until then, which outlives this.
  explicit MotionEnd(services::MotionGate& gate) : gate_(gate) {}
  /// Requires that finish() was called, if begin_end() was.
  ~MotionEnd() override = default;

  /// The end: `done` is called on a thread of its own when all stands, or the services have not said so in time. Waits
  /// for nothing. Both outlive finish(). Once.
  void begin_end(services::Host& host, Cores& cores, std::function<void()> done);
  /// Waits for no service any more; `done` has been called, or never is.
  void finish();

  Expected<std::uint64_t> begin(const services::Beginning& run) override;
  Expected<void> may_force(const services::Beginning& run) override { return gate_.may_force(run); }
  bool confirms_edits(const std::string& core) override { return gate_.confirms_edits(core); }
  std::optional<Value> refuse(const services::Caller& caller, const std::string& service,
                              rsm::CallEffect effect) override;
  void release(const std::string& core, const std::string& service) override { gate_.release(core, service); }

 private:
  using Steady = std::chrono::steady_clock::time_point;
  bool is_moving(const services::Host& host) const;
  void await_stand(const services::Host& host, bool is_moving) const;

  services::MotionGate& gate_;
  std::atomic<Steady> last_motion_{Steady()};  // when the gate let one pass
  std::atomic<bool> ended_{false}, given_up_{false};
  Pool pool_{1, 0, "motion end"};
};

}  // namespace race::server
