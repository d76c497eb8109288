// How much has been computed (Linux).
#pragma once

#include <chrono>
#include <ctime>

namespace race::services {

/// The time that processors have worked, by a clock of clock_gettime().
inline std::chrono::nanoseconds computed_time(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}
/// For the thread that calls.
inline std::chrono::nanoseconds thread_time() { return computed_time(CLOCK_THREAD_CPUTIME_ID); }
/// For this program.
inline std::chrono::nanoseconds process_time() { return computed_time(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace race::services
