// What is known of the times of a run, as clients see it.
//
// Threads: any.
#pragma once

#include <cstdint>
#include <vector>

#include "core/value/expected.h"
#include "server/store/runs.h"

namespace race::server {

inline constexpr std::uint64_t kMostTimes = 1000;  // macro steps of an answer
inline constexpr std::size_t kMostStates = 5000;   // of services, in an answer

/// The blocks of a run from the one on that has macro step `from`, up to the first that ends after `to`. `recent`: what
/// is not in the store yet, read before (TimingRecorder::blocks). Errors: those of Runs.
Expected<std::vector<TimingBlock>> timing_blocks(Runs& runs, RunId run, std::uint64_t from, std::uint64_t to,
                                                 const std::vector<TimingBlock>& recent = {});

/// schemas/timing.json of macro steps `from` to `to` of a run that has `to` of them at least.
Value timing_json(const std::vector<TimingBlock>& blocks, std::uint64_t from, std::uint64_t to);

}  // namespace race::server
