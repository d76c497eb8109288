#include "server/threads/strand.h"

#include <utility>

namespace race::server {

Pool::Pool(unsigned threads) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

Pool::~Pool() {
  {
    const services::MutexLock lock(mutex_);
    stop_ = true;
  }
  posted_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Pool::post(Work work) {
  {
    const services::MutexLock lock(mutex_);
    work_.push_back(std::move(work));
  }
  posted_.notify_one();
}

void Pool::run() {
  while (const auto work = next()) (*work)();
}

std::optional<Work> Pool::next() {
  const services::MutexLock lock(mutex_);
  posted_.wait(mutex_, [this]() REQUIRES(mutex_) { return stop_ || !work_.empty(); });
  if (work_.empty()) return std::nullopt;
  Work work = std::move(work_.front());
  work_.pop_front();
  return work;
}

void Strand::Queue::post(const std::shared_ptr<Queue>& queue, Work work) {
  {
    const services::MutexLock lock(queue->mutex);
    queue->work.push_back(std::move(work));
    if (std::exchange(queue->scheduled, true)) return;
  }
  queue->pool.post([queue] { run_one(queue); });
}

// One piece of work, then the others' turn: no strand keeps a thread of the pool.
void Strand::Queue::run_one(const std::shared_ptr<Queue>& queue) {
  Work work;
  {
    const services::MutexLock lock(queue->mutex);
    work = std::move(queue->work.front());
    queue->work.pop_front();
  }
  work();
  work = nullptr;
  {
    const services::MutexLock lock(queue->mutex);
    if (queue->work.empty()) {
      queue->scheduled = false;
      return;
    }
  }
  queue->pool.post([queue] { run_one(queue); });
}

}  // namespace race::server
