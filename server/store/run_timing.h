// The times of a run (timing.h): rows of the table `timing`, each held against its digest.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/value/expected.h"
#include "server/store/runs.h"
#include "server/store/statements.h"
#include "server/store/timing.h"

namespace race::server {

struct TimingRow {
  std::uint64_t last = 0;  // macro step
  std::string text;        // schemas/timing_block.json
};

TimingRow timing_row(const TimingBlock& block);
/// After the rows of the run that are there; the oldest go when there are more than TimingBlock::kMostBlocks. Requires
/// a transaction.
void write_timing(Statements& statements, RunId run, const TimingRow& row);
/// Shows the blocks that have times of macro step `from` or later ones to `take`, in order, until it says false. Error
/// `corrupt`, naming the block.
Expected<void> read_timing_rows(SQLite::Database& file, RunId run, std::uint64_t from,
                                const std::function<bool(const TimingBlock&)>& take);

}  // namespace race::server
