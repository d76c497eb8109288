#include "server/threads/memory_return.h"

#include <malloc.h>

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
  while (!closing_.wait_for(mutex_, period_, [this]() REQUIRES(mutex_) { return closed_; }))
    if (mallinfo2().fordblks > kFree) malloc_trim(0);
}

}  // namespace race::server
