// Inbox: what other threads have the group's thread do, in order. It is bounded: who posts more waits for room.
//
// Threads: post() any, the others the group's.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <thread>

#include "services/mutex.h"

namespace race::client {

class Inbox {
 public:
  static constexpr std::size_t kMost = 10'000;
  using Work = std::function<void()>;

  /// Takes what is posted, for the thread that calls.
  void open() EXCLUDES(mutex_);
  /// What waits, and what is posted from now on, is dropped.
  void close() EXCLUDES(mutex_);
  /// Does it at once on the group's thread, else in the next run().
  void post(Work work) EXCLUDES(mutex_);
  /// Does what was posted when it was called.
  void run() EXCLUDES(mutex_);

 private:
  /// Whether the work is to be done at once.
  bool keep(Work& work) EXCLUDES(mutex_);

  services::Mutex mutex_;
  services::ConditionVariable changed_;
  std::deque<Work> waiting_ GUARDED_BY(mutex_);
  std::thread::id group_ GUARDED_BY(mutex_);
  bool is_open_ GUARDED_BY(mutex_) = false;
};

}  // namespace race::client
