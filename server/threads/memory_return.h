// MemoryReturn: gives the system back what the allocator keeps free, now and then. After a load, most of what was used
// is free, but in pieces within arenas that are never empty, which the allocator does not return by itself. Not during
// one: whoever needs memory waits meanwhile, for some ten milliseconds. And it lets the allocator have few arenas, from
// the threads on that begin later: what is free in one is of no use to another.
//
// Threads: one of its own.
#pragma once

#include <chrono>
#include <cstddef>
#include <thread>

#include "services/mutex.h"

namespace race::server {

class MemoryReturn {
 public:
  static constexpr std::chrono::seconds kPeriod{3};
  static constexpr std::size_t kFree = 2U << 20U;  // bytes that may stay: some percent of what a small cell takes
  static constexpr int kMostSince = 10;            // periods: what is used changes its place all the time
  static constexpr int kMostWaited = 20;           // periods, for the end of a load
  static constexpr int kArenas = 4;

  /// Throws std::system_error if no thread can be had.
  explicit MemoryReturn(std::chrono::milliseconds period = kPeriod);
  ~MemoryReturn();
  MemoryReturn(const MemoryReturn&) = delete;
  MemoryReturn& operator=(const MemoryReturn&) = delete;

 private:
  void run();

  const std::chrono::milliseconds period_;
  services::Mutex mutex_;
  services::ConditionVariable closing_;
  bool closed_ GUARDED_BY(mutex_) = false;
  std::thread thread_;
};

}  // namespace race::server
