// Watchdog: sets a flag when a piece of work has taken longer than it may; the work looks at the flag and gives up.
// Late by up to kPeriod.
//
// Threads: any; a thread of its own looks.
#pragma once

#include <atomic>
#include <chrono>
#include <list>
#include <memory>
#include <thread>

#include "services/mutex.h"

namespace race::server {

class Watchdog {
  using Clock = std::chrono::steady_clock;

 public:
  using Flag = std::shared_ptr<std::atomic<bool>>;
  static constexpr std::chrono::milliseconds kPeriod{20};

  /// Throws std::system_error if no thread can be had.
  Watchdog() : thread_([this] { run(); }) {}
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

  /// A piece of work that is watched as long as this lives. The watchdog outlives it.
  class Watch;
  /// From now on, `flag` becomes true when `limit` is over.
  [[nodiscard]] Watch watch(Flag flag, std::chrono::milliseconds limit) EXCLUDES(mutex_);

 private:
  struct Entry {
    Clock::time_point end;
    Flag flag;
  };
  using Entries = std::list<Entry>;
  void run();
  void release(Entries::iterator entry) EXCLUDES(mutex_);

  services::Mutex mutex_;
  services::ConditionVariable closing_;
  Entries entries_ GUARDED_BY(mutex_);
  bool closed_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

class Watchdog::Watch {
 public:
  Watch(Watchdog& watchdog, Entries::iterator entry) : watchdog_(watchdog), entry_(entry) {}
  ~Watch() { watchdog_.release(entry_); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

 private:
  Watchdog& watchdog_;
  Entries::iterator entry_;
};

}  // namespace race::server
