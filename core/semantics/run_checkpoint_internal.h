// The parts of Run::read_checkpoint.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/semantics/context.h"
#include "core/semantics/run.h"
#include "core/value/fields.h"

namespace race::semantics {

/// The greatest number in a checkpoint.
inline constexpr std::uint64_t kMostInCheckpoint = std::numeric_limits<std::int64_t>::max();

/// A number from `least` to `most`; `least` if it is absent (a violation if it is required), or another (a violation).
std::uint64_t read_number(Fields& fields, std::string_view key, std::uint64_t least, std::uint64_t most,
                          Fields::Need need = Fields::Need::optional);

/// Reads Δ and Σ of a run at `position` into `run`, that of a new run. Its lists and counts stay empty.
void read_run_state(Fields& fields, const Program& program, std::uint64_t position, RunState& run,
                    std::vector<Error>& errors);

/// Adds to `errors` (`conflict`, at `path` and the state) what cannot be in a run that has begun.
void check_run_state(const Program& program, const RunState& run, Status status, const std::string& path,
                     std::vector<Error>& errors);

}  // namespace race::semantics
