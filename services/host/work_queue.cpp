#include "services/host/work_queue.h"

#include <iterator>

#include "services/failures.h"

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
  for (auto each = work.begin(); each != work.end(); ++each) try {
      (*each)();
    } catch (...) {
      const MutexLock lock(mutex_);
      work_.insert(work_.begin(), std::move_iterator(each + 1), std::move_iterator(work.end()));
      throw;
    }
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
      run_reporting("work of a service", [this] { run(); });
    }
  });
}

WorkThread::~WorkThread() {
  post([this] { stop_ = true; });
  thread_.join();
}

}  // namespace race::services
