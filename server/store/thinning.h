// Thinning: rows of a run that come again and again, such as samples, have a bound: when there are more, every second
// one is dropped, and from then on only every second one is kept.
//
// Threads: those of the file.
#pragma once

#include <cstddef>
#include <cstdint>

#include "server/store/runs.h"

namespace SQLite {
class Database;
}

namespace race::server {

/// How far the rows of a run have come. Numbers are from 0; kept are those that `every`, a power of two, divides.
struct Thinning {
  std::int64_t seen = 0, every = 1;
  std::int64_t bytes = 0;  // of those that are kept
  std::size_t kept() const { return static_cast<std::size_t>((seen + every - 1) / every); }
};

/// The tables: `state` (run, seen, every, bytes), and `rows` (run, number, ..., the column `content`, ...).
struct ThinnedTable {
  const char *state, *rows, *content;
};

/// Whether the run is there. All throw SQLite::Exception.
bool has_run(SQLite::Database& file, RunId run);
Thinning read_thinning(SQLite::Database& file, const ThinnedTable& table, RunId run);
void write_thinning(SQLite::Database& file, const ThinnedTable& table, RunId run, const Thinning& thinning);
/// Drops every second row.
void thin_out(SQLite::Database& file, const ThinnedTable& table, RunId run, Thinning& thinning);

}  // namespace race::server
