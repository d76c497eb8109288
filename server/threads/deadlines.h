// Deadlines: work that is due after a time, on a thread of its own: who waits for something that does not come is
// answered all the same.
//
// Threads: any but its own.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class Deadlines {
  using Clock = std::chrono::steady_clock;

 public:
  /// Names what is due, for drop().
  using Id = std::pair<Clock::time_point, std::uint64_t>;

  /// Throws std::system_error if there is no thread.
  Deadlines() : thread_([this] { run(); }) {}
  ~Deadlines() { close(); }
  Deadlines(const Deadlines&) = delete;
  Deadlines& operator=(const Deadlines&) = delete;

  /// Does `work`, which must be quick, once `time` has passed, unless it is dropped before. It looks whether what is
  /// waited for has come meanwhile.
  Id after(std::chrono::milliseconds time, Work work) EXCLUDES(mutex_);
  /// What has come is not waited for any more. Work that is being done, was done, or was dropped stays so.
  void drop(const Id& id) EXCLUDES(mutex_);
  /// How many are not due yet.
  std::size_t size() const EXCLUDES(mutex_);
  /// What is not due yet, or comes later, is dropped; what is being done is waited for.
  void close() EXCLUDES(mutex_);

 private:
  void run();
  /// Waits for work that is due; nothing: closed.
  std::optional<Work> next() EXCLUDES(mutex_);

  mutable services::Mutex mutex_;
  services::ConditionVariable changed_;
  std::map<Id, Work> work_ GUARDED_BY(mutex_);  // in the order of their times
  std::uint64_t last_ GUARDED_BY(mutex_) = 0;
  bool closed_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace race::server
