#include "server/threads/deadlines.h"

#include <utility>

#include "services/failures.h"
#include "services/thread_name.h"

namespace race::server {

Deadlines::Id Deadlines::after(std::chrono::milliseconds time, Work work) {
  Id id;
  {
    const services::MutexLock lock(mutex_);
    if (closed_) return {};
    id = {Clock::now() + time, ++last_};
    work_.emplace(id, std::move(work));
  }
  changed_.notify_one();
  return id;
}

void Deadlines::drop(const Id& id) {
  decltype(work_)::node_type dropped;  // after the lock: it may own what asks for more
  const services::MutexLock lock(mutex_);
  dropped = work_.extract(id);
}

std::size_t Deadlines::size() const {
  const services::MutexLock lock(mutex_);
  return work_.size();
}

void Deadlines::close() {
  decltype(work_) dropped;  // after the lock: it may own what asks for more
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
    dropped.swap(work_);
  }
  changed_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Deadlines::run() {
  services::name_thread("deadlines");
  while (auto work = next()) services::run_reporting("a deadline", *work);
}

std::optional<Work> Deadlines::next() {
  const services::MutexLock lock(mutex_);
  while (!closed_) {
    if (work_.empty()) {
      changed_.wait(mutex_, [this]() REQUIRES(mutex_) { return closed_ || !work_.empty(); });
      continue;
    }
    const Clock::time_point due = work_.begin()->first.first, now = Clock::now();
    if (due <= now) return std::move(work_.extract(work_.begin()).mapped());
    changed_.wait_for(mutex_, due - now,
                      [&]() REQUIRES(mutex_) { return closed_ || work_.empty() || work_.begin()->first.first < due; });
  }
  return std::nullopt;
}

}  // namespace race::server
