// What is recomputed of a stored run: its derivations, and how it differs from another one. The work of a question is
// bounded: a replay begins at the nearest checkpoint, and answers say where to go on.
//
// Threads: any; each question has a replay of its own. If somebody sets `stop`, which may be null, a question ends
// soon, with an answer to be thrown away.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "core/execution/replay.h"
#include "core/execution/why.h"
#include "core/value/expected.h"
#include "server/store/runs.h"

namespace race::server {

inline constexpr std::uint64_t kMostDerivations = 100;  // macro steps of an answer
inline constexpr std::uint64_t kMostCompared = 2000;    // macro steps of an answer

/// schemas/derivations.json of macro steps `from` to `to`, at most kMostDerivations; `from` 0: the last one, `to` 0:
/// `from`. Errors: `not_found`, `out_of_range`, those of Runs and Replay.
Expected<Value> run_derivations(Runs& runs, RunId id, std::uint64_t from, std::uint64_t to,
                                const std::atomic<bool>* stop = nullptr);

/// schemas/past.json of the moment after micro step `micro` of macro step `step`, or of its end if it has fewer.
/// Errors: as run_derivations.
Expected<Value> run_past(Runs& runs, RunId id, std::uint64_t step, int micro, const std::atomic<bool>* stop = nullptr);

/// schemas/why.json of what is asked about, as things were in micro step `micro` of macro step `step`, or at the end of
/// it if it has fewer; `step` 0: the last one. Errors: as run_derivations, and those of find_subject.
Expected<Value> run_why(Runs& runs, RunId id, const execution::WhyQuestion& question, std::uint64_t step, int micro,
                        const std::atomic<bool>* stop = nullptr);

/// schemas/run_comparison.json of two runs, from macro step `from` on (from 1), at most `most` macro steps. Errors: as
/// run_derivations; `out_of_range`: one of them is shorter than `from`.
Expected<Value> compare_runs(Runs& runs, RunId first, RunId second, std::uint64_t from,
                             std::uint64_t most = kMostCompared, const std::atomic<bool>* stop = nullptr);

}  // namespace race::server
