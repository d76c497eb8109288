// Where the components of one group run: a queue of work that its owner runs on the group's thread. WorkQueue is run by
// a loop that has other things to do (the cell's, a headless run's); WorkThread is a group with a thread of its own.
#pragma once

#include <functional>
#include <thread>
#include <vector>

#include "services/mutex.h"

namespace race::services {

/// Threads: post() on any; run() on the group's alone.
class WorkQueue {
 public:
  using Work = std::function<void()>;
  virtual ~WorkQueue() = default;
  void post(Work work) EXCLUDES(mutex_);
  /// Runs what had been posted when it was called, in order; whether there was anything. Throws what work throws; what
  /// was posted after that stays.
  bool run() EXCLUDES(mutex_);

 protected:
  /// Waits until there is work.
  void wait() EXCLUDES(mutex_);

 private:
  Mutex mutex_;
  ConditionVariable posted_;
  std::vector<Work> work_ GUARDED_BY(mutex_);
};

/// A group with its own thread: runs what is posted until it is destroyed; work posted before that is still done. Work
/// that throws is over, and reported (services/failures.h).
class WorkThread final : public WorkQueue {
 public:
  WorkThread();
  ~WorkThread() override;

 private:
  bool stop_ = false;  // of the thread
  std::thread thread_;
};

}  // namespace race::services
