#include "server/store/run_numbers.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>

#include "services/sqlite/file.h"

namespace race::server {

RunId last_run_number(SQLite::Database& file) {
  SQLite::Statement select(file,
                           "SELECT coalesce(max(n), 0) FROM (SELECT seq AS n FROM sqlite_sequence WHERE name = 'run'"
                           " UNION ALL SELECT (SELECT max(id) FROM run WHERE id <= ?1)) WHERE n BETWEEN 0 AND ?1");
  select.bind(1, sqlite::integer(kLastRunNumber));
  select.executeStep();
  return static_cast<RunId>(select.getColumn(0).getInt64());
}

RunId take_run_number(SQLite::Database& file) {
  const RunId next = last_run_number(file) + 1;
  raise_run_numbers(file, next);
  return next;
}

// SQLite keeps the row for AUTOINCREMENT, and makes it with the first run.
void raise_run_numbers(SQLite::Database& file, RunId last) {
  const auto number = static_cast<std::int64_t>(std::max(last, last_run_number(file)));
  SQLite::Statement update(file, "UPDATE sqlite_sequence SET seq = ? WHERE name = 'run'");
  update.bind(1, number);
  if (update.exec() > 0) return;
  SQLite::Statement insert(file, "INSERT INTO sqlite_sequence VALUES ('run', ?)");
  insert.bind(1, number);
  insert.exec();
}

}  // namespace race::server
