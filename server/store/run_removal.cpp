#include "server/store/run_removal.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <array>
#include <string>
#include <vector>

#include "server/store/digest_column.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

constexpr std::int64_t kPicturesAtOnce = 32;  // up to 64 kilobytes each
constexpr std::int64_t kTimingsAtOnce = 16;   // up to a hundred kilobytes each

struct Removal {
  const char* sql;
  std::int64_t rows;  // at once
};
constexpr std::array kRemovals = {
    Removal{"DELETE FROM entry WHERE run = ?1 AND position IN"
            " (SELECT position FROM entry WHERE run = ?1 ORDER BY position LIMIT ?2)",
            kRunRowsAtOnce},
    Removal{"DELETE FROM checkpoint WHERE run = ?1 AND position IN"
            " (SELECT position FROM checkpoint WHERE run = ?1 ORDER BY position LIMIT ?2)",
            1},  // up to eight megabytes
    Removal{"DELETE FROM sample WHERE run = ?1 AND number IN"
            " (SELECT number FROM sample WHERE run = ?1 ORDER BY number LIMIT ?2)",
            kRunRowsAtOnce},
    Removal{"DELETE FROM picture WHERE run = ?1 AND number IN"
            " (SELECT number FROM picture WHERE run = ?1 ORDER BY number LIMIT ?2)",
            kPicturesAtOnce},
    Removal{"DELETE FROM timing WHERE run = ?1 AND number IN"
            " (SELECT number FROM timing WHERE run = ?1 ORDER BY number LIMIT ?2)",
            kTimingsAtOnce},
    Removal{"DELETE FROM sampling WHERE run IN (SELECT run FROM sampling WHERE run = ?1 LIMIT ?2)", 1},
    Removal{"DELETE FROM picturing WHERE run IN (SELECT run FROM picturing WHERE run = ?1 LIMIT ?2)", 1}};

sqlite::Digest digest_of(RunId run) { return sqlite::sha256_of({"removal", std::to_string(run)}); }

bool has_row(SQLite::Database& file, RunId run) {
  SQLite::Statement select(file, "SELECT 1 FROM run WHERE id = ?");
  select.bind(1, sqlite::integer(run));
  return select.executeStep();
}

bool remove_rows(SQLite::Database& file, RunId run) {
  for (const Removal& each : kRemovals) {
    SQLite::Statement remove(file, each.sql);
    remove.bind(1, sqlite::integer(run));
    remove.bind(2, each.rows);
    if (remove.exec() > 0) return true;
  }
  return false;
}

}  // namespace

void begin_removal(SQLite::Database& file, RunId run) {
  SQLite::Statement insert(file, "INSERT OR REPLACE INTO removal VALUES (?, ?)");
  insert.bind(1, sqlite::integer(run));
  bind_digest(insert, 2, digest_of(run));
  insert.exec();
}

// A row that is damaged names none.
bool is_being_removed(SQLite::Database& file, RunId run) {
  SQLite::Statement select(file, "SELECT digest FROM removal WHERE run = ?");
  select.bind(1, sqlite::integer(run));
  return select.executeStep() && digest_in(select, 0) == digest_of(run);
}

void end_removal(SQLite::Database& file, RunId run) {
  SQLite::Statement remove(file, "DELETE FROM removal WHERE run = ?");
  remove.bind(1, sqlite::integer(run));
  remove.exec();
}

bool remove_some(SQLite::Database& file, RunId run) {
  sqlite::WriteTransaction transaction(file);
  if (!is_being_removed(file, run) || has_row(file, run)) return false;
  const bool removed = remove_rows(file, run);
  if (!removed) end_removal(file, run);
  transaction.commit();
  return removed;
}

void finish_removals(SQLite::Database& file) {
  std::vector<RunId> runs;
  SQLite::Statement select(file, "SELECT run FROM removal");
  while (select.executeStep()) runs.push_back(static_cast<RunId>(select.getColumn(0).getInt64()));
  select.reset();
  for (const RunId run : runs)
    while (remove_some(file, run)) {
    }
}

}  // namespace race::server
