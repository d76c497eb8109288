#include "api/cpp/race_client/workers.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "services/thread_name.h"

namespace race::client {
namespace {

// A time that the standard library can add to its clocks.
std::chrono::duration<double> duration(double seconds) {
  constexpr double kMost = 1e6;
  return std::chrono::duration<double>(seconds > 0 ? std::min(seconds, kMost) : 0);
}

}  // namespace

Workers::~Workers() {
  const services::MutexLock lock(mutex_);
  changed_.wait(mutex_, [this]() REQUIRES(mutex_) { return is_idle(); });
  for (Worker& worker : workers_) worker.thread.join();
}

bool Workers::is_idle() const {
  return std::ranges::all_of(workers_, [](const Worker& worker) { return worker.is_done; });
}

bool Workers::has_room() {
  join_done();
  const services::MutexLock lock(mutex_);
  return workers_.size() < kMost;
}

// A thread that is done has nothing left to do but to give back the mutex.
void Workers::join_done() {
  List done;
  {
    const services::MutexLock lock(mutex_);
    for (auto next = workers_.begin(); next != workers_.end();) {
      const auto each = next++;
      if (each->is_done) done.splice(done.end(), workers_, each);
    }
  }
  for (Worker& worker : done) worker.thread.join();
}

void Workers::start(std::shared_ptr<RunningCall> call, std::function<void()> work) {
  const services::MutexLock lock(mutex_);
  workers_.push_back({std::move(call), {}});
  const auto self = std::prev(workers_.end());
  try {
    self->thread = std::thread([this, self, work = std::move(work)] { this->work(self, work); });
  } catch (...) {
    workers_.erase(self);
    throw;
  }
}

void Workers::work(List::iterator self, const std::function<void()>& work) {
  services::name_thread("race_handler");
  {
    const services::MutexLock lock(mutex_);
    changed_.wait(mutex_, [&]() REQUIRES(mutex_) {
      return self->call->over || std::ranges::none_of(workers_, [&](const Worker& other) {
               return &other != &*self && !other.is_done && other.call->over;
             });
    });
  }
  work();
  const services::MutexLock lock(mutex_);
  self->is_done = true;
  changed_.notify_all();
}

void Workers::end(RunningCall& call) {
  const services::MutexLock lock(mutex_);
  call.over = true;
  changed_.notify_all();
}

bool Workers::wait_for_end(const RunningCall& call, double seconds) {
  const services::MutexLock lock(mutex_);
  return changed_.wait_for(mutex_, duration(seconds), [&]() { return call.over.load(); });
}

bool Workers::wait_for_all(double seconds) {
  const services::MutexLock lock(mutex_);
  return changed_.wait_for(mutex_, duration(seconds), [this]() REQUIRES(mutex_) { return is_idle(); });
}

}  // namespace race::client
