// The checkpoints of a run: rows of the table `checkpoint`, each held against its digest.
//
// Threads: those of the connection. All may throw SQLite::Exception.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "server/store/runs.h"

namespace race::server {

/// The checkpoint after the macro step at `position`: the text of schemas/checkpoint.json. Requires a transaction.
void write_checkpoint(SQLite::Database& file, RunId run, std::uint64_t position, const std::string& text);
/// The newest one at or before `position`; unknown: there is none. Error `corrupt`, naming the checkpoint.
Expected<Value> read_checkpoint(SQLite::Database& file, RunId run, std::uint64_t position);
/// Positions of all, in order.
std::vector<std::uint64_t> list_checkpoints(SQLite::Database& file, RunId run);

}  // namespace race::server
