#include "server/threads/memory_return.h"

#include <malloc.h>

#include <algorithm>
#include <utility>

#include "services/computed_time.h"
#include "services/thread_name.h"

namespace race::server {

MemoryReturn::MemoryReturn(std::chrono::milliseconds period) : period_(period) {
  mallopt(M_ARENA_MAX, kArenas);
  thread_ = std::thread([this] { run(); });
}

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
  int since = 0;         // periods after the last time
  auto used = services::process_time();
  while (!closing_.wait_for(mutex_, period_, [this]() REQUIRES(mutex_) { return closed_; })) {
    const bool is_calm = services::process_time() - std::exchange(used, services::process_time()) < period_ / 2;
    const std::size_t free = mallinfo2().fordblks;
    left = std::min(left, free);
    ++since;
    const bool is_much = free > left + kFree;
    if (!is_much) waited = 0;
    const bool is_due = is_much ? is_calm || ++waited >= kMostWaited : is_calm && since >= kMostSince;
    if (!is_due) continue;
    malloc_trim(0);
    left = mallinfo2().fordblks;
    waited = since = 0;
  }
}

}  // namespace race::server
