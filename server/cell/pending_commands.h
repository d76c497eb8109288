// PendingCommands: commands to the cell whose results handlers wait for. Handler threads are few, so few commands may
// be pending, each for a limited time; a command that timed out before it began never executes.
//
// Threads: any.
#pragma once

#include <chrono>
#include <functional>

#include "server/cell/cell_world.h"
#include "services/mutex.h"

namespace race::server {

class PendingCommands {
 public:
  static constexpr int kMaxPending = 2;

  struct Timeouts {
    std::chrono::milliseconds admission{100};    // until fewer than kMaxPending are pending
    std::chrono::milliseconds completion{5000};  // until the command has begun and has its result
    std::chrono::milliseconds grace{1000};       // added if it has begun by then
  };

  explicit PendingCommands(const Timeouts& timeouts) : timeouts_(timeouts) {}
  PendingCommands() : PendingCommands(Timeouts()) {}

  /// Calls `start` on this thread and waits for the result. Errors: those of the command; `unavailable`: kMaxPending
  /// others are pending, or the command timed out before it began (it will not execute) or after (it may execute).
  Expected<Value> wait(const std::function<void(CellWorld::Wanted, CellWorld::Done)>& start) EXCLUDES(mutex_);

 private:
  const Timeouts timeouts_;
  services::Mutex mutex_;
  services::ConditionVariable free_;
  int pending_ GUARDED_BY(mutex_) = 0;
};

}  // namespace race::server
