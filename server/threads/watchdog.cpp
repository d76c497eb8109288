#include "server/threads/watchdog.h"

#include <utility>

#include "services/thread_name.h"

namespace race::server {

Watchdog::~Watchdog() {
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
  }
  closing_.notify_all();
  thread_.join();
}

Watchdog::Watch Watchdog::watch(Flag flag, std::chrono::milliseconds limit) {
  const services::MutexLock lock(mutex_);
  entries_.push_back({Clock::now() + limit, std::move(flag)});
  return {*this, std::prev(entries_.end())};
}

void Watchdog::release(Entries::iterator entry) {
  const services::MutexLock lock(mutex_);
  entries_.erase(entry);
}

void Watchdog::run() {
  services::name_thread("watchdog");
  const services::MutexLock lock(mutex_);
  while (!closing_.wait_for(mutex_, kPeriod, [this]() REQUIRES(mutex_) { return closed_; })) {
    const Clock::time_point now = Clock::now();
    for (const Entry& entry : entries_)
      if (entry.end <= now) *entry.flag = true;
  }
}

}  // namespace race::server
