// Clock: the one source of time for every service and for the server. Nothing else reads a clock. It counts seconds of
// the cell's world from the start; where there is no world, of what paces the cell.
//
// Threads: now() may be called on any.
#pragma once

#include <atomic>

#include "services/component.h"

namespace race::services {

class Clock {
 public:
  virtual ~Clock() = default;
  /// Seconds since the clock began; never goes back.
  virtual Time now() const = 0;
};

/// World time: set by the thread that steps the world.
class WorldClock final : public Clock {
 public:
  Time now() const override { return now_.load(std::memory_order_acquire); }
  /// Requires time >= now().
  void set(Time time) { now_.store(time, std::memory_order_release); }

 private:
  std::atomic<Time> now_{0.0};
};

}  // namespace race::services
