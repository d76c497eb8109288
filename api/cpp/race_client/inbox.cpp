#include "api/cpp/race_client/inbox.h"

#include <utility>

namespace race::client {

void Inbox::open() {
  const services::MutexLock lock(mutex_);
  group_ = std::this_thread::get_id();
  is_open_ = true;
}

void Inbox::close() {
  const services::MutexLock lock(mutex_);
  is_open_ = false;
  waiting_.clear();
  changed_.notify_all();
}

void Inbox::post(Work work) {
  if (keep(work)) work();
}

bool Inbox::keep(Work& work) {
  const services::MutexLock lock(mutex_);
  if (is_open_ && group_ == std::this_thread::get_id()) return true;
  changed_.wait(mutex_, [this]() REQUIRES(mutex_) { return !is_open_ || waiting_.size() < kMost; });
  if (is_open_) waiting_.push_back(std::move(work));
  return false;
}

void Inbox::run() {
  std::deque<Work> due;
  {
    const services::MutexLock lock(mutex_);
    if (waiting_.empty()) return;
    due.swap(waiting_);
    changed_.notify_all();
  }
  for (const Work& work : due) work();
}

}  // namespace race::client
