// The row of a run, as it is written by Runs and JournalWriter, with its digest. All may throw SQLite::Exception.
//
// Threads: those of the connection.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/store/runs.h"
#include "server/store/statements.h"
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

/// A new row. Requires a transaction, that the header and the services are stored, and a number that no run has had
/// (run_numbers.h).
void write_row(Statements& statements, const RunRecord& run);
/// The row of this run, as the record is now. Error `not_found`: it is not there; nothing is written.
Expected<void> update_row(Statements& statements, const RunRecord& run);

/// The statement that selects rows for read_row(): `rest` is what follows FROM.
std::string select_runs(std::string_view rest);
/// The row at which `select` stands. Error `corrupt`, naming the run.
Expected<RunRecord> read_row(SQLite::Statement& select);
/// At most `most` rows that `select` has, and whether there are more.
RunList read_rows(SQLite::Statement& select, std::size_t most);
/// The row of a run. Errors: `not_found`; `corrupt`: it is damaged, or lost and there are entries of the run.
Expected<RunRecord> find_row(SQLite::Database& file, RunId id);
/// Runs of which there are entries and no row, but for those that are being removed or imported (run_removal.h).
std::vector<RunId> lost_runs(SQLite::Database& file);
/// Error `corrupt`: the row of the run is lost.
Error lost_row(RunId id);

}  // namespace race::server
