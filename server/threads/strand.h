// Pool and Strand: threads that do work, and an order of work. What is posted to a strand runs in order, never two at a
// time, on some thread of its pool. A core lives on a strand; so do the stream and what recomputes derivations.
//
// Threads: post() and ask() on any.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace race::server {

using Work = std::function<void()>;

class Pool {
 public:
  explicit Pool(unsigned threads);
  /// Does what was posted, and what that posts; so whoever posts to itself has been stopped before.
  ~Pool();
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  void post(Work work);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable posted_;
  std::deque<Work> work_;
  bool stop_ = false;
  std::vector<std::thread> threads_;
};

class Strand {
 public:
  /// The pool outlives the strand's work.
  explicit Strand(Pool& pool) : queue_(std::make_shared<Queue>(pool)) {}
  void post(Work work) { Queue::post(queue_, std::move(work)); }

  /// Posts `function` and waits for its value, at most `patience`: nothing if the strand was busy for longer, in which
  /// case the function still runs, later. So it must hold what it needs. Not to be called on the strand itself.
  template <typename F>
  auto ask(F function, std::chrono::milliseconds timeout = std::chrono::seconds(5))
      -> std::optional<std::invoke_result_t<F>> {
    auto task = std::make_shared<std::packaged_task<std::invoke_result_t<F>()>>(std::move(function));
    auto answer = task->get_future();
    post([task] { (*task)(); });
    if (answer.wait_for(timeout) != std::future_status::ready) return std::nullopt;
    try {
      return answer.get();
    } catch (const std::future_error&) {  // the pool has ended
      return std::nullopt;
    }
  }

 private:
  // Kept alive by the work on its way through the pool.
  struct Queue {
    explicit Queue(Pool& its_pool) : pool(its_pool) {}
    static void post(const std::shared_ptr<Queue>& queue, Work work);
    static void run_one(const std::shared_ptr<Queue>& queue);
    Pool& pool;
    std::mutex mutex;
    std::deque<Work> work;
    bool scheduled = false;
  };
  std::shared_ptr<Queue> queue_;
};

}  // namespace race::server
