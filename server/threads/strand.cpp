#include "server/threads/strand.h"

#include <utility>

#include "services/failures.h"

namespace race::server {

Pool::Pool(unsigned threads) : running_(threads) {
  try {
    for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
  } catch (...) {  // no thread can be had
    end();
    throw;
  }
}

void Pool::end() {
  {
    const services::MutexLock lock(mutex_);
    stop_ = true;
  }
  posted_.notify_all();
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
  posted_.notify_one();
  return true;
}

void Pool::run() {
  while (auto work = next()) services::run_reporting("work of a thread", *work);
}

std::optional<Work> Pool::next() {
  const services::MutexLock lock(mutex_);
  posted_.wait(mutex_, [this]() REQUIRES(mutex_) { return stop_ || !work_.empty() || !later_.empty(); });
  if (work_.empty() && later_.empty()) {
    --running_;
    return std::nullopt;
  }
  std::deque<Work>& queue = next_queue();
  Work work = std::move(queue.front());
  queue.pop_front();
  return work;
}

// Requires that work waits.
std::deque<Work>& Pool::next_queue() {
  const bool later = work_.empty() || (!later_.empty() && since_later_ >= kLaterAfter);
  since_later_ = later || later_.empty() ? 0 : since_later_ + 1;
  return later ? later_ : work_;
}

void Strand::Queue::post(const std::shared_ptr<Queue>& queue, Work work, Pool::Turn turn) {
  Piece dropped;  // after the lock: it may own what posts
  const services::MutexLock lock(queue->mutex);
  queue->work.push_back({std::move(work), turn});
  if (queue->scheduled) return;
  try {
    queue->scheduled = queue->pool.post([queue] { run_one(queue); }, turn);
  } catch (...) {  // it is not posted: who posts next gets the strand going
    queue->work.pop_back();
    throw;
  }
  if (queue->scheduled) return;
  dropped = std::move(queue->work.back());
  queue->work.pop_back();
}

void Strand::finish() {
  const services::MutexLock lock(queue_->mutex);
  queue_->done.wait(queue_->mutex, [this]() REQUIRES(queue_->mutex) { return !queue_->scheduled; });
}

// One piece of work, then the others' turn: no strand keeps a thread of the pool, unless there is no memory for a turn.
void Strand::Queue::run_one(const std::shared_ptr<Queue>& queue) {
  for (bool given_up = false; !given_up;) {
    Work work;
    {
      const services::MutexLock lock(queue->mutex);
      work = std::move(queue->work.front().work);
      queue->work.pop_front();
    }
    services::run_reporting("work of a strand", work);
    work = nullptr;
    Pool::Turn turn = Pool::Turn::now;
    {
      const services::MutexLock lock(queue->mutex);
      if (queue->work.empty()) {
        queue->scheduled = false;
        queue->done.notify_all();
        return;
      }
      turn = queue->work.front().turn;
    }
    given_up =
        services::run_reporting("the turn of a strand", [&] { queue->pool.post([queue] { run_one(queue); }, turn); });
  }
}

}  // namespace race::server
