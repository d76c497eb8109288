#include "server/store/thinning.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <string>

#include "services/sqlite/file.h"

namespace race::server {

bool has_run(SQLite::Database& file, RunId run) {
  SQLite::Statement select(file, "SELECT 1 FROM run WHERE id = ?");
  select.bind(1, sqlite::integer(run));
  return select.executeStep();
}

Thinning read_thinning(SQLite::Database& file, const ThinnedTable& table, RunId run) {
  SQLite::Statement select(file, "SELECT seen, every, bytes FROM " + std::string(table.state) + " WHERE run = ?");
  select.bind(1, sqlite::integer(run));
  if (!select.executeStep()) return {};
  // A damaged row costs rows, no more.
  return {std::max<std::int64_t>(0, select.getColumn(0).getInt64()),
          std::max<std::int64_t>(1, select.getColumn(1).getInt64()), select.getColumn(2).getInt64()};
}

void write_thinning(SQLite::Database& file, const ThinnedTable& table, RunId run, const Thinning& thinning) {
  SQLite::Statement insert(file, "INSERT OR REPLACE INTO " + std::string(table.state) + " VALUES (?, ?, ?, ?)");
  insert.bind(1, sqlite::integer(run));
  insert.bind(2, thinning.seen);
  insert.bind(3, thinning.every);
  insert.bind(4, thinning.bytes);
  insert.exec();
}

void thin_out(SQLite::Database& file, const ThinnedTable& table, RunId run, Thinning& thinning) {
  thinning.every *= 2;
  const std::string rows = table.rows;
  SQLite::Statement remove(file, "DELETE FROM " + rows + " WHERE run = ? AND number % ? <> 0");
  remove.bind(1, sqlite::integer(run));
  remove.bind(2, thinning.every);
  remove.exec();
  SQLite::Statement sum(
      file, "SELECT coalesce(sum(length(" + std::string(table.content) + ")), 0) FROM " + rows + " WHERE run = ?");
  sum.bind(1, sqlite::integer(run));
  sum.executeStep();
  thinning.bytes = sum.getColumn(0).getInt64();
}

}  // namespace race::server
