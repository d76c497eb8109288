// Texts that runs share: headers of journals without their arguments, lists of services. Each is stored once, under its
// digest (schema.h, `header`), and removed with the last run that has it.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include "core/value/expected.h"
#include "server/store/runs.h"

namespace race::server {

/// What a run has of its header and its services, in the record; stores their texts. Requires a transaction.
void describe(SQLite::Database& file, const Runs::NewRun& run, RunRecord& record);

/// schemas/journal.json, `header`: its fields in the order in which they are hashed. Error `corrupt`, naming the run.
Expected<Value> read_header_text(SQLite::Database& file, const RunRecord& run);
/// Key -> RSM (schemas/service.json). Error `corrupt`, naming the run.
Expected<Value> read_services_text(SQLite::Database& file, const RunRecord& run);

/// Removes what no run has any more. Requires a transaction.
void remove_unused_texts(SQLite::Database& file);

}  // namespace race::server
