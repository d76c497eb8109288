// The entries of a run's journal: rows of the table `entry`, held against the chain of hashes (journal_chain.h).
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/execution/journal.h"
#include "core/value/expected.h"
#include "server/store/runs.h"
#include "server/store/statements.h"

namespace race::server {

struct EntryRow {
  std::uint64_t position = 0;
  std::string input;          // schemas/input.json
  sqlite::Digest chain = {};  // after it
};

/// The next entry of a run: in the record, and the row to be written.
EntryRow append_entry(RunRecord& run, const execution::JournalEntry& entry);
/// Requires a transaction.
void write_entry(Statements& statements, RunId run, const EntryRow& row);

/// The rows `from` - 1 (if there is one) to `to`. Error `corrupt`, naming the entry: one is missing or is not as the
/// chain has it. Requires 1 <= from <= to <= run.steps, and a transaction, so that all is of one moment.
Expected<std::vector<EntryRow>> read_entry_rows(SQLite::Database& file, const RunRecord& run, std::uint64_t from,
                                                std::uint64_t to);

/// What the rows of read_entry_rows() say, those from `from` on. Error `corrupt`, naming the entry.
Expected<std::vector<execution::JournalEntry>> read_entries(const std::vector<EntryRow>& rows, RunId run,
                                                            std::uint64_t from);

}  // namespace race::server
