// Workers: the threads on which handlers of busy operations work.
//
// Threads: any, but for start(), which is for one.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <thread>

#include "api/cpp/race_client/running_call.h"
#include "services/mutex.h"

namespace race::client {

class Workers {
 public:
  static constexpr std::size_t kMost = 100;  // handlers at work

  Workers() = default;
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  /// Waits for all.
  ~Workers();

  /// Whether another one may start.
  bool has_room() EXCLUDES(mutex_);
  /// Does `work` on a thread of its own. Before that it waits for handlers whose calls are over but which are still at
  /// work, as they may still move something; `call` may be over then. Throws std::system_error: there is no thread.
  void start(std::shared_ptr<RunningCall> call, std::function<void()> work) EXCLUDES(mutex_);
  /// The call is over.
  void end(RunningCall& call) EXCLUDES(mutex_);
  /// Whether the call is over within this time [s].
  bool wait_for_end(const RunningCall& call, double seconds) EXCLUDES(mutex_);
  /// Whether no handler is at work any more within this time [s].
  bool wait_for_all(double seconds) EXCLUDES(mutex_);

 private:
  struct Worker {
    std::shared_ptr<RunningCall> call;  // of those who answer it, too
    std::thread thread;
    bool is_done = false;
  };
  using List = std::list<Worker>;

  void work(List::iterator self, const std::function<void()>& work) EXCLUDES(mutex_);
  void join_done() EXCLUDES(mutex_);
  bool is_idle() const REQUIRES(mutex_);

  services::Mutex mutex_;
  services::ConditionVariable changed_;
  List workers_ GUARDED_BY(mutex_);
};

}  // namespace race::client
