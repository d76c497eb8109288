// Texts that runs share: headers of journals without their arguments, lists of services. Each is stored once, under its
// digest (schema.h, `header`), and removed with the last run that has it.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include <string>

#include "core/value/expected.h"
#include "server/store/runs.h"
#include "server/store/statements.h"

namespace race::server {

struct RunTexts {
  std::string header;    // schemas/journal.json, `header`, without `arguments`
  std::string services;  // key -> schemas/service.json
};

/// What a run has of its header and its services: in the record, and the texts to be stored with it.
RunTexts describe(const Runs::NewRun& run, RunRecord& record);
/// Stores the texts of a run. Requires a transaction.
void write_texts(Statements& statements, const RunRecord& run, const RunTexts& texts);

/// schemas/journal.json, `header`: its fields in the order in which they are hashed. Error `corrupt`, naming the run.
Expected<Value> read_header_text(SQLite::Database& file, const RunRecord& run);
/// Key -> RSM (schemas/service.json). Error `corrupt`, naming the run.
Expected<Value> read_services_text(SQLite::Database& file, const RunRecord& run);

/// Removes what no run has any more. Requires a transaction.
void remove_unused_texts(SQLite::Database& file);

}  // namespace race::server
