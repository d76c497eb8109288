// Clock: the one source of time for every service and for the server. Nothing else reads a clock. It is world time
// where there is a world, else steady time; both count seconds from the start of the process's cell or server.
//
// Threads: now() may be called on any.
#pragma once

#include <atomic>
#include <chrono>

#include "services/component.h"

namespace race::services {

class Clock {
 public:
  virtual ~Clock() = default;
  /// Seconds since the clock began; never goes back.
  virtual Time now() const = 0;
};

/// Steady time since it was made.
class SteadyClock final : public Clock {
 public:
  Time now() const override { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// World time: whoever steps the world sets it.
class WorldClock final : public Clock {
 public:
  Time now() const override { return now_.load(std::memory_order_acquire); }
  /// Requires time >= now().
  void set(Time time) { now_.store(time, std::memory_order_release); }

 private:
  std::atomic<Time> now_{0.0};
};

}  // namespace race::services
