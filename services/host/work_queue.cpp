#include "services/host/work_queue.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "services/computed_time.h"
#include "services/failures.h"
#include "services/thread_name.h"

namespace race::services {

void WorkQueue::post(Work work, Lane lane) {
  {
    const MutexLock lock(mutex_);
    if (closed_) return;
    work_.push_back({std::move(work), lane});
  }
  posted_.notify_one();
}

bool WorkQueue::run() {
  std::deque<Piece> pieces;
  {
    const MutexLock lock(mutex_);
    for (auto& [lane, work] : std::exchange(lanes_, {}))
      for (Work& each : work) pieces.push_back({std::move(each), lane});
    std::move(work_.begin(), work_.end(), std::back_inserter(pieces));
    work_.clear();
  }
  for (auto each = pieces.begin(); each != pieces.end(); ++each) try {
      each->work();
    } catch (...) {
      const MutexLock lock(mutex_);
      work_.insert(work_.begin(), std::move_iterator(each + 1), std::move_iterator(pieces.end()));
      throw;
    }
  return !pieces.empty();
}

void WorkQueue::run_for(std::chrono::microseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end) {
    const Work work = take_next();
    if (!work) return;
    work();
  }
}

WorkQueue::Work WorkQueue::take_next() {
  const MutexLock lock(mutex_);
  for (; !work_.empty(); work_.pop_front()) lanes_[work_.front().lane].push_back(std::move(work_.front().work));
  if (lanes_.empty()) return nullptr;
  auto lane = lanes_.find(kNoLane);
  if (lane == lanes_.end()) {
    lane = lanes_.upper_bound(last_lane_);
    if (lane == lanes_.end()) lane = lanes_.begin();
    last_lane_ = lane->first;
  }
  Work work = std::move(lane->second.front());
  lane->second.pop_front();
  if (lane->second.empty()) lanes_.erase(lane);
  return work;
}

void WorkQueue::wait() {
  const MutexLock lock(mutex_);
  posted_.wait(mutex_, [this]() REQUIRES(mutex_) { return !work_.empty() || !lanes_.empty(); });
}

WorkThread::WorkThread(const char* name, double share) : share_(share) {
  thread_ = std::thread([this, name] {
    name_thread(name);
    while (!stop_) {
      wait();
      run_reporting("work of a service", [this] { run(); });
      if (share_ < 1) rest();
    }
  });
}

// Looks every few milliseconds of computing whether that was more than its share of the time.
void WorkThread::rest() {
  constexpr std::chrono::milliseconds kTurn{2}, kMost{50};
  const auto used = thread_time() - computed_;
  if (used < kTurn) return;
  const auto due = std::chrono::duration_cast<std::chrono::nanoseconds>(used / share_);
  std::this_thread::sleep_until(std::min(began_ + due, std::chrono::steady_clock::now() + kMost));
  computed_ = thread_time();
  began_ = std::chrono::steady_clock::now();
}

void WorkQueue::close() {
  decltype(work_) dropped;  // after the lock: it may own what posts
  decltype(lanes_) dropped_lanes;
  const MutexLock lock(mutex_);
  closed_ = true;
  dropped.swap(work_);
  dropped_lanes.swap(lanes_);
}

void WorkThread::end() {
  if (!thread_.joinable()) return;
  post([this] { stop_ = true; });
  thread_.join();
  close();
}

}  // namespace race::services
