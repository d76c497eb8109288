// The checkpoints of a run: rows of the table `checkpoint`, each held against its digest.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/store/runs.h"
#include "server/store/statements.h"

namespace race::server {

struct CheckpointRow {
  std::uint64_t position = 0;  // after the macro step there
  std::string text;            // schemas/checkpoint.json
  sqlite::Digest digest = {};
};

CheckpointRow checkpoint_row(RunId run, std::uint64_t position, std::string text);
/// Requires a transaction.
void write_checkpoint(Statements& statements, RunId run, const CheckpointRow& row);
/// The newest one at or before `position`; unknown: there is none. Error `corrupt`, naming the checkpoint.
Expected<Value> read_checkpoint(SQLite::Database& file, RunId run, std::uint64_t position);
/// Positions of all, in order.
std::vector<std::uint64_t> list_checkpoints(SQLite::Database& file, RunId run);

}  // namespace race::server
