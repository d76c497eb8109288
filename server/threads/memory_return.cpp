#include "server/threads/memory_return.h"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <utility>

#include "services/thread_name.h"

namespace race::server {
namespace {

/// The time that processors have worked for this program.
std::chrono::nanoseconds process_time() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

MemoryReturn::~MemoryReturn() {
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
  }
  closing_.notify_all();
  thread_.join();
}

void MemoryReturn::run() {
  services::name_thread("memory");
  const services::MutexLock lock(mutex_);
  std::size_t left = 0;  // free after the last time, in pieces that are too small
  int waited = 0;        // periods under load
  auto used = process_time();
  while (!closing_.wait_for(mutex_, period_, [this]() REQUIRES(mutex_) { return closed_; })) {
    const bool is_calm = process_time() - std::exchange(used, process_time()) < period_ / 2;
    const std::size_t free = mallinfo2().fordblks;
    left = std::min(left, free);
    if (free <= left + kFree) {
      waited = 0;
      continue;
    }
    if (!is_calm && ++waited < kMostWaited) continue;
    malloc_trim(0);
    left = mallinfo2().fordblks;
    waited = 0;
  }
}

}  // namespace race::server
