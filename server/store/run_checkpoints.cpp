#include "server/store/run_checkpoints.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <utility>

#include "core/execution/journal.h"
#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/run_row.h"
#include "services/sqlite/file.h"

namespace race::server {
namespace {

sqlite::Digest digest_of(RunId run, std::uint64_t position, std::string_view text) {
  return sqlite::sha256_of({std::to_string(run), std::to_string(position), text});
}

}  // namespace

CheckpointRow checkpoint_row(RunId run, std::uint64_t position, std::string text) {
  const sqlite::Digest digest = digest_of(run, position, text);
  return {position, std::move(text), digest};
}

void write_checkpoint(Statements& statements, RunId run, const CheckpointRow& row) {
  const auto insert = statements.use("INSERT OR REPLACE INTO checkpoint VALUES (?, ?, ?, ?)");
  insert->bind(1, sqlite::integer(run));
  insert->bind(2, sqlite::integer(row.position));
  insert->bind(3, row.text);
  bind_digest(*insert, 4, row.digest);
  insert->exec();
}

Expected<Value> read_checkpoint(SQLite::Database& file, RunId run, std::uint64_t position) {
  SQLite::Statement select(file,
                           "SELECT position, text, digest FROM checkpoint WHERE run = ? AND position <= ?"
                           " ORDER BY position DESC LIMIT 1");
  select.bind(1, sqlite::integer(run));
  select.bind(2, sqlite::integer(position));
  if (!select.executeStep()) return Value::unknown();
  const auto found = static_cast<std::uint64_t>(select.getColumn(0).getInt64());
  const std::string text = select.getColumn(1).getString();
  if (digest_in(select, 2) != digest_of(run, found, text))
    return damaged("a checkpoint", path_of(run) + "/checkpoints/" + std::to_string(found));
  return parse_json(text, execution::kJournalLimits);
}

std::vector<std::uint64_t> list_checkpoints(SQLite::Database& file, RunId run) {
  SQLite::Statement select(file, "SELECT position FROM checkpoint WHERE run = ? ORDER BY position");
  select.bind(1, sqlite::integer(run));
  std::vector<std::uint64_t> positions;
  while (select.executeStep()) positions.push_back(static_cast<std::uint64_t>(select.getColumn(0).getInt64()));
  return positions;
}

}  // namespace race::server
