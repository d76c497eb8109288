// Where the components of one group run: a queue of work that its owner runs on the group's thread. WorkQueue is run by
// a loop that has other things to do (the cell's, a headless run's); WorkThread is a group with a thread of its own.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <thread>
#include <vector>

#include "services/mutex.h"

namespace race::services {

/// Threads: post() on any; run() and run_for() on the group's alone.
class WorkQueue {
 public:
  using Work = std::function<void()>;
  virtual ~WorkQueue() = default;
  /// Whose work it is: that of one lane stays in order. What has none stays in order too, and waits for no lane.
  using Lane = std::uint64_t;
  static constexpr Lane kNoLane = 0;
  void post(Work work, Lane lane = kNoLane) EXCLUDES(mutex_);
  /// Runs what had been posted when it was called, in order; whether there was anything. Throws what work throws; what
  /// was posted after that stays.
  bool run() EXCLUDES(mutex_);
  /// Runs what is posted until `time` is over: what has no lane first, then a piece of each lane in turn, so that who
  /// posts much delays nobody else. Throws likewise.
  void run_for(std::chrono::microseconds time) EXCLUDES(mutex_);

 protected:
  /// Waits until there is work.
  void wait() EXCLUDES(mutex_);
  /// What is posted, now or later, is dropped.
  void close() EXCLUDES(mutex_);

 private:
  struct Piece {
    Work work;
    Lane lane;
  };
  /// Nothing: there is none.
  Work take_next() EXCLUDES(mutex_);

  Mutex mutex_;
  ConditionVariable posted_;
  std::deque<Piece> work_ GUARDED_BY(mutex_);
  std::map<Lane, std::deque<Work>> lanes_ GUARDED_BY(mutex_);  // posted before all of work_; none is empty
  Lane last_lane_ GUARDED_BY(mutex_) = kNoLane;                // that had its turn
  bool closed_ GUARDED_BY(mutex_) = false;
};

/// A group with its own thread: runs what is posted until it ends; work posted before that is still done. Work that
/// throws is over, and reported (services/failures.h).
class WorkThread final : public WorkQueue {
 public:
  /// `name`: services/thread_name.h. `share` of a processor that it may use, looked at after each batch of work: who
  /// gives it more to do has to wait. Of what others say, so that their floods take neither the processors nor the
  /// locks from who has little to do.
  explicit WorkThread(const char* name = "services", double share = 1);
  ~WorkThread() override { end(); }
  /// Not on its thread. What is posted later is dropped: who still has work for a group need not know that it has
  /// ended.
  void end();

 private:
  void rest();

  const double share_;
  std::chrono::nanoseconds computed_{0};         // of the thread, as the next: since
  std::chrono::steady_clock::time_point began_;  // it began or has rested
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace race::services
