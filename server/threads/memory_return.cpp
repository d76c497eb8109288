#include "server/threads/memory_return.h"

#include <malloc.h>

#include <algorithm>

namespace race::server {

MemoryReturn::~MemoryReturn() {
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
  }
  closing_.notify_all();
  thread_.join();
}

void MemoryReturn::run() {
  const services::MutexLock lock(mutex_);
  std::size_t left = 0;  // free after the last time, in pieces that are too small
  while (!closing_.wait_for(mutex_, period_, [this]() REQUIRES(mutex_) { return closed_; })) {
    const std::size_t free = mallinfo2().fordblks;
    if (free > left + kFree) malloc_trim(0);
    left = free > left + kFree ? mallinfo2().fordblks : std::min(left, free);
  }
}

}  // namespace race::server
