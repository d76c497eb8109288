// Deadlines: work that is due after a time, on a thread of its own: who waits for something that does not come is
// answered all the same.
//
// Threads: any but its own.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <thread>

#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class Deadlines {
 public:
  /// Throws std::system_error if there is no thread.
  Deadlines() : thread_([this] { run(); }) {}
  ~Deadlines() { close(); }
  Deadlines(const Deadlines&) = delete;
  Deadlines& operator=(const Deadlines&) = delete;

  /// Does `work`, which must be quick, once `time` has passed. What has come meanwhile is not taken back: the work
  /// looks.
  void after(std::chrono::milliseconds time, Work work) EXCLUDES(mutex_);
  /// What is not due yet, or comes later, is dropped; what is being done is waited for.
  void close() EXCLUDES(mutex_);

 private:
  using Clock = std::chrono::steady_clock;
  void run();
  /// Waits for work that is due; nothing: closed.
  std::optional<Work> next() EXCLUDES(mutex_);

  services::Mutex mutex_;
  services::ConditionVariable changed_;
  std::multimap<Clock::time_point, Work> work_ GUARDED_BY(mutex_);
  bool closed_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace race::server
