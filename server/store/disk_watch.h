// DiskWatch: tells a run whose records the disk has not taken for too long. A disk that hangs interrupts a run as one
// that fails does (core/SEMANTICS.md section 10): the robot does not go on while nothing can be stored.
//
// Threads: any; a thread of its own looks.
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <thread>

#include "server/store/run_sink.h"
#include "services/mutex.h"

namespace race::server {

class DiskWatch {
 public:
  /// Longer than any flush of a disk that works takes, and shorter than a person would wait.
  static constexpr std::chrono::milliseconds kTimeout{5000};

  explicit DiskWatch(std::chrono::milliseconds timeout);
  ~DiskWatch();

  /// One more record of `journal` waits for the disk; `sink` is notified when it has waited too long.
  void waits(const void* journal, const std::weak_ptr<RunSink>& sink) EXCLUDES(mutex_);
  /// `records` of `journal` wait no more: whether its sink was notified that the disk hangs.
  bool answered(const void* journal, std::size_t records) EXCLUDES(mutex_);

 private:
  using Clock = std::chrono::steady_clock;
  struct Waiting {
    std::weak_ptr<RunSink> sink;
    std::size_t records = 0;
    Clock::time_point since;
    bool notified = false;
  };
  void run();
  void notify_sinks() REQUIRES(mutex_);

  const std::chrono::milliseconds timeout_;
  services::Mutex mutex_;
  services::ConditionVariable closing_;
  std::map<const void*, Waiting> waiting_ GUARDED_BY(mutex_);
  bool closed_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace race::server
