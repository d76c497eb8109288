// How much a thread has computed (Linux).
#pragma once

#include <chrono>
#include <ctime>

namespace race::services {

/// The time that a processor has worked for the thread that calls.
inline std::chrono::nanoseconds thread_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace race::services
