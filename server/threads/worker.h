// Worker: a thread of its own for work that may take long, such as replays, so that it delays nothing else. Its queue
// is bounded, who asks waits for a bounded time, and work that nobody waits for any more is told to stop.
//
// Threads: any but its own.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/value/expected.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class Worker {
 public:
  using Stop = std::atomic<bool>;
  /// Pieces of work that wait or are done. Fewer than there are threads of handlers: one of them stays free.
  static constexpr std::size_t kMost = 3;
  static constexpr std::chrono::seconds kTurn{5};  // until a piece begins

  /// Waits for the work that is being done.
  ~Worker() { stop(); }

  /// Does `function(stop)` when what was asked before is done, and gives its value. Waits at most kTurn until it
  /// begins, then at most `limit`. If that is not enough, or the worker is stopped, `stop` becomes true and the
  /// function should return soon; it may go on until then, so it must own what it uses. Errors: `unavailable`: there
  /// are kMost pieces of work, its turn does not come, or the worker is stopped; `too_large`: it takes longer than
  /// `limit`.
  template <typename F>
  auto ask(F function, std::chrono::milliseconds limit) -> Expected<std::invoke_result_t<F, const Stop&>>;

  /// What is asked is told to stop, and nothing begins any more.
  void stop() EXCLUDES(mutex_);

 private:
  /// False: there is no room for it.
  bool post(const std::shared_ptr<Stop>& stop, Work work) EXCLUDES(mutex_);

  services::Mutex mutex_;
  std::vector<std::shared_ptr<Stop>> pieces_ GUARDED_BY(mutex_);  // that wait or are done
  bool stopped_ GUARDED_BY(mutex_) = false;
  Pool pool_{1};
};

template <typename F>
auto Worker::ask(F function, std::chrono::milliseconds limit) -> Expected<std::invoke_result_t<F, const Stop&>> {
  using Value = std::invoke_result_t<F, const Stop&>;
  const auto stop = std::make_shared<Stop>(false);
  auto begun = std::make_shared<std::promise<void>>();
  auto task = std::make_shared<std::packaged_task<Value(const Stop&)>>(std::move(function));
  const auto turn = begun->get_future();
  auto value = task->get_future();
  const auto is_ready = [](const auto& future, std::chrono::milliseconds most) {
    return future.wait_for(most) == std::future_status::ready;
  };
  if (!post(stop, [stop, begun = std::move(begun), task = std::move(task)] {
        begun->set_value();
        (*task)(*stop);
      }))
    return unexpected(ErrorCode::unavailable, "there is no room for more replays now; ask again");
  if (!is_ready(turn, kTurn)) {
    *stop = true;
    return unexpected(ErrorCode::unavailable, "other replays take long; ask again");
  }
  if (!is_ready(value, limit)) {
    *stop = true;
    return unexpected(ErrorCode::too_large, "the replay takes longer than " + std::to_string(limit.count()) + " ms");
  }
  if (*stop) return unexpected(ErrorCode::unavailable, "the server ends");
  return value.get();
}

}  // namespace race::server
