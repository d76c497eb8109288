// WaitingActs: acts in a cell whose answers somebody waits for, on threads that others need too. Few wait at a time,
// for a while; an act that is given up is not done later.
//
// Threads: any.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

#include "server/cell/cell_world.h"

namespace race::server {

class WaitingActs {
 public:
  static constexpr int kPlaces = 2;

  struct Patience {
    std::chrono::milliseconds place{100};   // until one of kPlaces is free
    std::chrono::milliseconds begin{5000};  // until the act is begun and answered
    std::chrono::milliseconds end{1000};    // more, for one that has begun by then
  };

  explicit WaitingActs(const Patience& patience) : patience_(patience) {}
  WaitingActs() : WaitingActs(Patience()) {}

  /// Starts the act, on this thread, and waits for its answer. Errors: those of the act; `unavailable`: other acts wait
  /// already, or it is not begun in time (it will not be done), or has begun and is not answered (it may be).
  Expected<Value> wait(const std::function<void(CellWorld::Wanted, CellWorld::Done)>& start);

 private:
  const Patience patience_;
  std::mutex mutex_;
  std::condition_variable free_;
  int waiting_ = 0;
};

}  // namespace race::server
