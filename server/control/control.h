// Control: what may set the cell in motion now. A stop latches: until a reset, no motion begins, and no run goes on
// that was under way. A service that a run has set in motion is reserved for it until the run is over.
//
// Not a safety function.
//
// Threads: any. Waits for nothing but its own lock, which nobody holds for long.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "services/host/motion_gate.h"
#include "services/mutex.h"

namespace race::server {

class Control final : public services::MotionGate {
 public:
  /// Who stopped the cell, and when [ms since 1970].
  struct Stop {
    std::string by;
    std::int64_t time = 0;
  };
  /// `changed` gets schemas/control.json, frozen, in order of the changes; under the lock: must be quick.
  explicit Control(std::function<void(const Value&)> changed) : changed_(std::move(changed)) {}

  /// From now on nothing may set the cell in motion. Of several stops the first is told. The fencing number that runs
  /// have is good no longer, also after the reset. Whether it was not stopped before.
  bool stop(Stop stop) EXCLUDES(mutex_);
  /// Motions may begin again; none does by that.
  void reset() EXCLUDES(mutex_);
  std::optional<Stop> stopped() const EXCLUDES(mutex_);
  /// The port of the stop server, for pages, by the port of the place at which they are.
  void set_stop_port(std::uint16_t place, std::uint16_t port) EXCLUDES(mutex_);
  /// schemas/control.json, frozen.
  Value json() const EXCLUDES(mutex_);

  Expected<std::uint64_t> begin() override EXCLUDES(mutex_);
  /// Errors {code, message} of core/SEMANTICS.md, R7: `stopped`: the cell is, or was since the run began; `leased`:
  /// another run has the service. The first call of a run that may is what reserves the service.
  std::optional<Value> refuse(const services::Caller& caller, const std::string& service) override EXCLUDES(mutex_);
  void release(const std::string& core, const std::string& service) override EXCLUDES(mutex_);

 private:
  Value state() const REQUIRES(mutex_);
  void tell() REQUIRES(mutex_) { changed_(state()); }

  const std::function<void(const Value&)> changed_;
  mutable services::Mutex mutex_;
  std::optional<Stop> stopped_ GUARDED_BY(mutex_);
  std::uint64_t fence_ GUARDED_BY(mutex_) = 1;
  std::map<std::string, std::string> leases_ GUARDED_BY(mutex_);  // service -> core
  std::map<std::uint16_t, std::uint16_t> stop_ports_ GUARDED_BY(mutex_);
};

}  // namespace race::server
