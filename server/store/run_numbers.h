// Numbers of runs: no number is used twice, also if its run was removed, or the store has become an older one (a backup
// that is restored goes on after the last number of the store that it replaces).
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include "server/store/runs.h"

namespace race::server {

/// The largest number of a run: JSON's numbers are exact up to it. What a store says beyond it is damage.
inline constexpr RunId kLastRunNumber = (RunId{1} << 53U) - 1;

/// The last number that a run of this store, or of one that it replaced, has had; 0: none.
RunId last_run_number(SQLite::Database& file);
/// The next number. Requires a transaction.
RunId take_run_number(SQLite::Database& file);
/// From now on, numbers are larger than `last`. Requires a transaction.
void raise_run_numbers(SQLite::Database& file, RunId last);

}  // namespace race::server
