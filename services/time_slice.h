// How soon a thread gets a processor when more threads compute than there are processors (Linux).
#pragma once

#include <chrono>
#include <optional>

namespace race::services {

/// The shortest that Linux has.
constexpr std::chrono::nanoseconds kShortSlice = std::chrono::microseconds(100);

/// The time slice of the thread that calls. Nothing: the kernel has none for each thread.
std::optional<std::chrono::nanoseconds> time_slice();

/// For the thread that calls, which computes little at a time and is waited for: when it is woken, it begins before
/// threads with longer slices have used up theirs. Its share of the processors stays what it is. From Linux 6.12 on
/// (sched_setattr(2): sched_runtime of SCHED_OTHER); before, nothing happens.
void shorten_time_slice();

}  // namespace race::services
