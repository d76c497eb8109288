#include "server/threads/strand.h"

#include <sys/resource.h>

#include <utility>

#include "services/failures.h"
#include "services/thread_name.h"

namespace race::server {

Pool::Pool(unsigned threads, unsigned later_threads, const char* name)
    : name_(name), has_later_threads_(later_threads > 0), running_(threads + later_threads) {
  try {
    start(threads, has_later_threads_ ? Duty::now : Duty::any);
    start(later_threads, Duty::later);
  } catch (...) {  // no thread can be had
    end();
    throw;
  }
}

void Pool::start(unsigned threads, Duty duty) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this, duty] { run(duty); });
}

void Pool::end() {
  {
    const services::MutexLock lock(mutex_);
    stop_ = true;
  }
  posted_.notify_all();
  posted_later_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void Pool::drop() {
  std::deque<Work> dropped, dropped_later;  // after the lock: it may own what posts
  const services::MutexLock lock(mutex_);
  dropped.swap(work_);
  dropped_later.swap(later_);
}

bool Pool::post(Work work, Turn turn) {
  {
    const services::MutexLock lock(mutex_);
    if (running_ == 0) return false;
    (turn == Turn::now ? work_ : later_).push_back(std::move(work));
  }
  (turn == Turn::later && has_later_threads_ ? posted_later_ : posted_).notify_one();
  return true;
}

// Of a thread (Linux): the rest of turns yields the processor to all that is waited for.
void Pool::run(Duty duty) {
  constexpr int kLaterNice = 10;
  services::name_thread(name_);
  if (duty == Duty::later) setpriority(PRIO_PROCESS, 0, kLaterNice);
  while (auto work = next(duty)) services::run_reporting("work of a thread", *work);
}

std::optional<Work> Pool::next(Duty duty) {
  const services::MutexLock lock(mutex_);
  std::deque<Work>* queue = nullptr;
  const auto is_there = [&]() REQUIRES(mutex_) { return (queue = next_queue(duty)) != nullptr || stop_; };
  (duty == Duty::later ? posted_later_ : posted_).wait(mutex_, is_there);
  if (!queue) {
    --running_;
    return std::nullopt;
  }
  Work work = std::move(queue->front());
  queue->pop_front();
  return work;
}

// Nothing: no work waits for a thread of this duty.
std::deque<Work>* Pool::next_queue(Duty duty) {
  const bool any = duty == Duty::any || stop_;
  const bool takes_now = (any || duty == Duty::now) && !work_.empty();
  const bool takes_later = (any || duty == Duty::later) && !later_.empty();
  if (!takes_now && !takes_later) return nullptr;
  const bool later = !takes_now || (takes_later && since_later_ >= kLaterAfter);
  if (any) since_later_ = later || later_.empty() ? 0 : since_later_ + 1;
  return later ? &later_ : &work_;
}

bool Strand::Queue::post_turn(const std::shared_ptr<Queue>& queue, Pool::Turn turn) {
  const bool posted = queue->pool.post([queue, number = queue->turn_number] { run_one(queue, number); }, turn);
  queue->waits_for_later = turn == Pool::Turn::later;
  return posted;
}

void Strand::Queue::post(const std::shared_ptr<Queue>& queue, Work work, Pool::Turn turn) {
  Work dropped;  // after the lock: it may own what posts
  const services::MutexLock lock(queue->mutex);
  const bool hurries = turn == Pool::Turn::now && queue->waits_for_later;
  std::deque<Work>& pieces = turn == Pool::Turn::now ? queue->now : queue->later;
  pieces.push_back(std::move(work));
  if (queue->scheduled && !hurries) return;
  try {
    ++queue->turn_number;
    queue->scheduled = post_turn(queue, turn);
  } catch (...) {  // it is not posted: a turn that waits is still one, else who posts next gets the strand going
    --queue->turn_number;
    pieces.pop_back();
    throw;
  }
  if (queue->scheduled) return;
  dropped = std::move(pieces.back());
  pieces.pop_back();
}

void Strand::finish() {
  const services::MutexLock lock(queue_->mutex);
  queue_->done.wait(queue_->mutex, [this]() REQUIRES(queue_->mutex) { return !queue_->scheduled; });
}

Work Strand::Queue::take_next() {
  const bool takes_later = now.empty() || (!later.empty() && since_later >= Pool::kLaterAfter);
  since_later = takes_later || later.empty() ? 0 : since_later + 1;
  std::deque<Work>& pieces = takes_later ? later : now;
  Work work = std::move(pieces.front());
  pieces.pop_front();
  return work;
}

// One piece of work, then the others' turn: no strand keeps a thread of the pool, unless there is no memory for a turn.
void Strand::Queue::run_one(const std::shared_ptr<Queue>& queue, std::uint64_t turn_number) {
  for (bool given_up = false; !given_up;) {
    Work work;
    {
      const services::MutexLock lock(queue->mutex);
      if (queue->turn_number != turn_number) return;
      queue->waits_for_later = false;
      work = queue->take_next();
    }
    services::run_reporting("work of a strand", work);
    work = nullptr;
    {
      const services::MutexLock lock(queue->mutex);
      if (queue->now.empty() && queue->later.empty()) {
        queue->scheduled = false;
        queue->done.notify_all();
        return;
      }
    }
    given_up = services::run_reporting("the turn of a strand", [&] {
      const services::MutexLock lock(queue->mutex);
      post_turn(queue, queue->now.empty() ? Pool::Turn::later : Pool::Turn::now);
    });
  }
}

}  // namespace race::server
