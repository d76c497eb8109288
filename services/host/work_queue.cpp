#include "services/host/work_queue.h"

namespace race::services {

void WorkQueue::post(Work work) {
  {
    const MutexLock lock(mutex_);
    work_.push_back(std::move(work));
  }
  posted_.notify_one();
}

bool WorkQueue::run() {
  std::vector<Work> work;
  {
    const MutexLock lock(mutex_);
    work.swap(work_);
  }
  for (const Work& each : work) each();
  return !work.empty();
}

void WorkQueue::wait() {
  const MutexLock lock(mutex_);
  posted_.wait(mutex_, [this]() REQUIRES(mutex_) { return !work_.empty(); });
}

WorkThread::WorkThread() {
  thread_ = std::thread([this] {
    while (!stop_) {
      wait();
      run();
    }
  });
}

WorkThread::~WorkThread() {
  post([this] { stop_ = true; });
  thread_.join();
}

}  // namespace race::services
