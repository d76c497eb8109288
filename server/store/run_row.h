// The row of a run, as it is written by Runs and JournalWriter, with its digest. All may throw SQLite::Exception.
//
// Threads: those of the connection.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/store/runs.h"
#include "services/sqlite/digest.h"

namespace race::server {

/// The columns that read_row() reads, in its order.
inline constexpr std::string_view kRunColumns =
    "id, document, revision, header, services, arguments, status, outcome, fault, results, steps, chain, created, "
    "ended,"
    " imported, bytes, digest";

/// How errors name a run.
std::string path_of(RunId id);
/// `what` at `path` is damaged: error `corrupt`.
tl::unexpected<Error> damaged(const std::string& what, std::string path);

/// Of all fields of a run's row.
sqlite::Digest digest_of(const RunRecord& run);

/// A new row; gives the run its number, which no run had before. Requires a transaction, and that the header and the
/// services are stored.
void write_row(SQLite::Database& file, RunRecord& run);
/// The row of this run, as the record is now.
void update_row(SQLite::Database& file, const RunRecord& run);

/// The statement that selects rows for read_row(): `rest` is what follows FROM.
std::string select_runs(std::string_view rest);
/// The row at which `select` stands. Error `corrupt`, naming the run.
Expected<RunRecord> read_row(SQLite::Statement& select);
/// All rows that `select` has from here on. Error `corrupt`, naming the first damaged run.
Expected<std::vector<RunRecord>> read_rows(SQLite::Statement& select);
/// The row of a run. Errors: `not_found`, `corrupt`.
Expected<RunRecord> find_row(SQLite::Database& file, RunId id);

}  // namespace race::server
