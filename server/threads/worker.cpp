#include "server/threads/worker.h"

#include <utility>

#include "services/failures.h"

namespace race::server {

bool Worker::post(const std::shared_ptr<Stop>& stop, Work work) {
  const services::MutexLock lock(mutex_);
  if (stopped_ || pieces_.size() >= kMost) return false;
  pieces_.reserve(kMost);
  pool_.post([this, stop, work = std::move(work)]() mutable {
    if (!*stop) services::run_reporting("a replay", work);
    work = nullptr;  // what it has not done is answered
    const services::MutexLock done(mutex_);
    std::erase(pieces_, stop);
  });
  pieces_.push_back(stop);  // under the lock: before its work is over
  return true;
}

void Worker::stop() {
  const services::MutexLock lock(mutex_);
  stopped_ = true;
  for (const auto& piece : pieces_) *piece = true;
}

}  // namespace race::server
