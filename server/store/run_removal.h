// Removal of a run: its row goes first, and with it the run; its entries, checkpoints, samples and times follow in
// short transactions, as the journals of other runs wait for each. The table `removal` names the runs of which
// something may be left, so that a removal that was interrupted is finished when the store is opened. A run that is
// imported is named there until it is whole.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include "server/store/runs.h"

namespace race::server {

/// How many rows of a run are removed, or of an imported one are stored, in one transaction.
inline constexpr std::size_t kRunRowsAtOnce = 1000;

/// What the store has under this number is to be removed, unless a row in `run` is added before. Requires a
/// transaction.
void begin_removal(SQLite::Database& file, RunId run);
bool is_being_removed(SQLite::Database& file, RunId run);
/// The run is whole, or nothing is left of it. Requires a transaction.
void end_removal(SQLite::Database& file, RunId run);

/// Removes the next rows of a run, in a transaction of its own, and ends the removal after the last ones. False: the
/// run is not being removed (any more).
bool remove_some(SQLite::Database& file, RunId run);
/// Finishes all removals. Requires that no run is being imported.
void finish_removals(SQLite::Database& file);

}  // namespace race::server
