// A run as it was: what somebody sees who goes back to an earlier micro step.
#pragma once

#include <atomic>
#include <string>

#include "core/execution/replay.h"

namespace race::execution {

/// Everything that decides how the run goes on, but for what waits: equal for equal moments of one run.
std::string moment_text(const Execution& execution);

/// A moment of a run, as a value.
struct Past {
  Dict json;         // schemas/past.json, without `digest`
  std::string text;  // moment_text
  std::uint32_t micro = 0;
  bool complete = false;  // as in `json`
};

/// After `micro` micro steps of macro step `step`. Requires as Replay::before. Errors: those of it.
Expected<Past> past(Replay& replay, std::uint64_t step, int micro, const std::atomic<bool>* stop = nullptr);

}  // namespace race::execution
