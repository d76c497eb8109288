// Comparison of two runs, macro step by macro step: where they first do different things.
//
// Pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/execution/journal_walk.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::execution {

/// The first macro step of which the derivations, the calls or the states after it differ. Inputs may differ without
/// that.
struct Difference {
  std::uint64_t step = 0;
  std::optional<std::size_t> micro = {};  // the first derivation that differs or that one lacks; none: all are the same
  Value first, second;                    // schemas/trace_step.json; null: this run has no such macro step
};

struct Comparison {
  std::uint64_t compared = 0;  // macro steps up to this one are the same in both, as far as they were walked
  std::optional<Difference> difference = {};
};

/// Walks both on, at most `most` macro steps, until they differ or both are at their end. Requires that both stand
/// before the same macro step. Errors: those of JournalWalk::next.
Expected<Comparison> compare(JournalWalk& first, JournalWalk& second, std::uint64_t most);

}  // namespace race::execution
