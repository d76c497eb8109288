// Rows of a run, its journal and its checkpoints, as they are written by Runs and JournalWriter: each with its digest.
// All may throw SQLite::Exception.
//
// Threads: those of the connection.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "server/store/runs.h"
#include "services/sqlite/digest.h"

namespace race::server {

/// The columns that read_row() reads, in its order.
inline constexpr std::string_view kRunColumns =
    "id, document, revision, header, services, arguments, status, outcome, fault, results, steps, chain, created, "
    "ended,"
    " imported, bytes, digest";

/// Of all fields of a run's row.
sqlite::Digest digest_of(const RunRecord& run);

/// A new row; gives the run its number, which no run had before. Requires a transaction, and that the header and the
/// services are stored.
void write_row(SQLite::Database& file, RunRecord& run);
/// The row of this run, as the record is now.
void update_row(SQLite::Database& file, const RunRecord& run);
/// The row at which `select` stands. Error `corrupt`, naming the run.
Expected<RunRecord> read_row(SQLite::Statement& select);

/// The entry at `position`, and the chain after it (journal_chain.h).
void write_entry(SQLite::Database& file, RunId run, std::uint64_t position, const std::string& input,
                 const sqlite::Digest& chain);
/// The checkpoint after the macro step at `position`: the text of schemas/checkpoint.json.
void write_checkpoint(SQLite::Database& file, RunId run, std::uint64_t position, const std::string& text);
/// Of a checkpoint's row.
sqlite::Digest checkpoint_digest(RunId run, std::uint64_t position, std::string_view text);

void bind_digest(SQLite::Statement& statement, int index, const sqlite::Digest& digest);
/// The digest in a column; one that is no text's if the column holds something else.
sqlite::Digest digest_in(SQLite::Statement& row, int column);

}  // namespace race::server
