// A moment of a run, with the digest by which it is compared, and what waited then.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "core/execution/past.h"
#include "server/store/runs.h"

namespace race::server {

/// A stored run, and what is known of its times that is not in the store yet.
struct TimedRun {
  Runs& runs;
  RunId id;
  std::vector<TimingBlock> recent;
};

inline constexpr std::size_t kMostWaitingShown = 100;

/// schemas/past.json. Requires as execution::past. Errors: those of it and of Runs.
Expected<Value> past_json(execution::Replay& replay, std::uint64_t step, int micro, const TimedRun& run,
                          const std::atomic<bool>* stop = nullptr);

}  // namespace race::server
