#include "server/store/disk_watch.h"

#include <algorithm>
#include <string>
#include <utility>

#include "services/failures.h"
#include "services/thread_name.h"

namespace race::server {

DiskWatch::DiskWatch(std::chrono::milliseconds timeout) : timeout_(timeout), thread_([this] { run(); }) {}

DiskWatch::~DiskWatch() {
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
  }
  closing_.notify_one();
  thread_.join();
}

void DiskWatch::waits(const void* journal, const std::weak_ptr<RunSink>& sink) {
  const services::MutexLock lock(mutex_);
  Waiting& waiting = waiting_[journal];
  if (waiting.records++ > 0) return;
  waiting.sink = sink;
  waiting.since = Clock::now();
}

// What waits still has waited for less than what is answered: its time begins anew.
bool DiskWatch::answered(const void* journal, std::size_t records) {
  const services::MutexLock lock(mutex_);
  const auto found = waiting_.find(journal);
  if (found == waiting_.end()) return false;
  Waiting& waiting = found->second;
  const bool notified = std::exchange(waiting.notified, false);
  waiting.records -= std::min(records, waiting.records);
  waiting.since = Clock::now();
  if (waiting.records == 0) waiting_.erase(found);
  return notified;
}

void DiskWatch::run() {
  services::name_thread("disk watch");
  const services::MutexLock lock(mutex_);
  while (!closed_) {
    closing_.wait_for(mutex_, timeout_ / 8, [this]() REQUIRES(mutex_) { return closed_; });
    notify_sinks();
  }
}

// Under the lock: a sink hears that its disk hangs before it hears how that ended.
void DiskWatch::notify_sinks() {
  const auto now = Clock::now();
  for (auto& [journal, waiting] : waiting_) {
    if (waiting.notified || now - waiting.since < timeout_) continue;
    const auto sink = waiting.sink.lock();
    waiting.notified = !sink || services::run_reporting("telling that the disk hangs", [&] {
      sink->stalled({ErrorCode::storage, "the disk has not answered for " + std::to_string(timeout_.count()) + " ms"});
    });
  }
}

}  // namespace race::server
