// PendingCommands: commands to the cell on their way. Few may be pending, each for a limited time; a command that timed
// out before it began never executes. Nobody waits for them on a thread.
//
// Threads: any.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>

#include "server/cell/cell_world.h"
#include "server/threads/deadlines.h"
#include "server/threads/done.h"

namespace race::server {

class PendingCommands {
 public:
  static constexpr int kMaxPending = 16;

  struct Timeouts {
    std::chrono::milliseconds completion{5000};  // until the command has begun and has its result
    std::chrono::milliseconds grace{1000};       // added if it has begun by then
  };

  explicit PendingCommands(const Timeouts& timeouts) : timeouts_(timeouts) {}
  PendingCommands() : PendingCommands(Timeouts()) {}

  /// Calls `start` on this thread and gives its result to `done`. Errors: those of the command; `unavailable`:
  /// kMaxPending others are pending, or the command timed out before it began (it will not execute) or after (it may
  /// execute). The deadlines outlive the command.
  void start(const std::function<void(CellWorld::Wanted, CellWorld::Done)>& start, Deadlines& deadlines,
             Done<Value> done);

 private:
  struct Command;

  const Timeouts timeouts_;
  const std::shared_ptr<std::atomic<int>> pending_ = std::make_shared<std::atomic<int>>(0);  // held by the commands
};

}  // namespace race::server
