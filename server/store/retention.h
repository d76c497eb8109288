// Retention: how many runs the store keeps. The oldest that are over go first; one that is not over, or is hosted,
// stays.
//
// Threads: any.
#pragma once

#include <cstdint>
#include <functional>

#include "core/value/expected.h"
#include "server/store/runs.h"

namespace race::server {

/// How much is kept at most, of runs that are over.
struct RetentionLimits {
  std::size_t runs = 1000;
  std::uint64_t bytes = std::uint64_t{1024} << 20U;  // of journals, checkpoints and samples
};

/// Removes what is beyond the limits, but for runs that `is_hosted`: these count, and stay. Gives how many it removed.
/// Errors: those of Runs.
Expected<std::size_t> apply_retention(Runs& runs, const RetentionLimits& limits,
                                      const std::function<bool(RunId)>& is_hosted);

}  // namespace race::server
