// Pool and Strand: worker threads, and sequences of work on them. Work posted to a strand runs in order, one at a time,
// on any thread of its pool. Each core has a strand; so does the stream. Work that throws is over, and reported
// (services/failures.h); what was posted after it is done all the same. A pool that has ended drops what is posted: who
// is still at work while the server ends needs no care.
//
// Fair turns: who has more to do than one turn allows posts the rest for later (post_later). That waits until all that
// was posted otherwise has had its turn, but for one in kLaterAfter, so that it does not wait for ever. So strands that
// are always busy share what the others leave. A pool may have threads of its own for that: then the others are there
// for all else, however long a piece of the rest takes.
//
// Threads: post() and ask() on any.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "services/mutex.h"

namespace race::server {

using Work = std::function<void()>;

class Pool {
 public:
  /// `name`: services/thread_name.h. Throws std::system_error if they cannot be had.
  explicit Pool(unsigned threads, unsigned later_threads = 0, const char* name = "pool");
  ~Pool() { end(); }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  enum class Turn : std::uint8_t { now, later };
  static constexpr unsigned kLaterAfter = 8;  // pieces of other work
  /// False: the pool has ended, and the work is dropped.
  bool post(Work work, Turn turn = Turn::now) EXCLUDES(mutex_);
  /// Finishes all posted work, and the work that it posts: work must not post itself for ever. Not on its threads.
  void end() EXCLUDES(mutex_);
  /// Drops the work that waits; what is being done goes on. Not on its threads.
  void drop() EXCLUDES(mutex_);

 private:
  enum class Duty : std::uint8_t { any, now, later };  // what work a thread does; any when the pool ends
  void start(unsigned threads, Duty duty);
  void run(Duty duty);
  /// Waits for work; nothing: the thread ends.
  std::optional<Work> next(Duty duty) EXCLUDES(mutex_);
  std::deque<Work>* next_queue(Duty duty) REQUIRES(mutex_);

  const char* const name_;
  const bool has_later_threads_;
  services::Mutex mutex_;
  services::ConditionVariable posted_, posted_later_;  // the latter for later_threads
  std::deque<Work> work_ GUARDED_BY(mutex_), later_ GUARDED_BY(mutex_);
  unsigned since_later_ GUARDED_BY(mutex_) = 0;  // pieces of other work that went before what waits in later_
  unsigned running_ GUARDED_BY(mutex_) = 0;      // threads
  bool stop_ GUARDED_BY(mutex_) = false;
  std::vector<std::thread> threads_;
};

class Strand {
 public:
  /// The pool outlives the strand's work.
  explicit Strand(Pool& pool) : queue_(std::make_shared<Queue>(pool)) {}
  void post(Work work) { Queue::post(queue_, std::move(work), Pool::Turn::now); }
  /// The rest of a turn of this strand: after what others have posted, and after what is posted here by post(), but for
  /// one in kLaterAfter.
  void post_later(Work work) { Queue::post(queue_, std::move(work), Pool::Turn::later); }
  /// Waits until all posted work is done. Not to be called on the strand itself.
  void finish();

  /// Posts `function` and waits for its value, at most `timeout`. Nothing: the strand was busy for longer; the function
  /// still runs later, so it must own what it uses. Not to be called on the strand itself.
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
  // Kept alive by its work in the pool.
  struct Queue {
    explicit Queue(Pool& its_pool) : pool(its_pool) {}
    static void post(const std::shared_ptr<Queue>& queue, Work work, Pool::Turn turn);
    static void run_one(const std::shared_ptr<Queue>& queue, std::uint64_t turn_number);
    /// Requires that there is work.
    Work take_next() REQUIRES(mutex);
    /// Posts its next turn; false: the pool has ended.
    static bool post_turn(const std::shared_ptr<Queue>& queue, Pool::Turn turn) REQUIRES(queue->mutex);
    Pool& pool;
    services::Mutex mutex;
    services::ConditionVariable done;
    std::deque<Work> now GUARDED_BY(mutex), later GUARDED_BY(mutex);
    unsigned since_later GUARDED_BY(mutex) = 0;  // pieces of now that went before what waits in later
    bool scheduled GUARDED_BY(mutex) = false;
    bool waits_for_later GUARDED_BY(mutex) = false;   // its turn does
    std::uint64_t turn_number GUARDED_BY(mutex) = 0;  // an earlier turn that still waits is none any more
  };
  std::shared_ptr<Queue> queue_;
};

}  // namespace race::server
