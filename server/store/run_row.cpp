#include "server/store/run_row.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/execution/journal.h"
#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/run_removal.h"
#include "services/sqlite/file.h"

namespace race::server {
namespace {

// Fields 1 to 17 of kRunColumns.
void bind_run(SQLite::Statement& row, const RunRecord& run) {
  row.bind(1, sqlite::integer(run.id));
  row.bind(2, run.document);
  row.bind(3, run.revision);
  bind_digest(row, 4, run.header);
  bind_digest(row, 5, run.services);
  row.bind(6, to_json(run.arguments));
  row.bind(7, run.status);
  row.bind(8, run.outcome);
  row.bind(9, to_json(run.fault));
  row.bind(10, to_json(run.results));
  row.bind(11, sqlite::integer(run.steps));
  bind_digest(row, 12, run.chain);
  row.bind(13, run.created_ms);
  row.bind(14, run.ended_ms);
  row.bind(15, run.imported ? 1 : 0);
  row.bind(16, sqlite::integer(run.bytes));
  bind_digest(row, 17, digest_of(run));
}

Value read_value(const SQLite::Column& column) {
  Value value = parse_json(column.getString(), execution::kJournalLimits).value_or(Value());
  return value.freeze();
}

tl::unexpected<Error> no_run(RunId id) {
  return unexpected(ErrorCode::not_found, "there is no run of this number", path_of(id));
}

}  // namespace

std::string path_of(RunId id) { return "runs/" + std::to_string(id); }

tl::unexpected<Error> damaged(const std::string& what, std::string path) {
  return unexpected(ErrorCode::corrupt, what + " is damaged", std::move(path));
}

sqlite::Digest digest_of(const RunRecord& run) {
  const auto text = [](auto n) { return std::to_string(n); };
  return sqlite::sha256_of({text(run.id), run.document, text(run.revision), sqlite::bytes(run.header),
                            sqlite::bytes(run.services), to_json(run.arguments), run.status, run.outcome,
                            to_json(run.fault), to_json(run.results), text(run.steps), sqlite::bytes(run.chain),
                            text(run.created_ms), text(run.ended_ms), run.imported ? "1" : "0", text(run.bytes)});
}

void write_row(Statements& statements, const RunRecord& run) {
  const auto insert = statements.use(
      "INSERT INTO run VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, ?17)");
  bind_run(*insert, run);
  insert->exec();
}

Expected<void> update_row(Statements& statements, const RunRecord& run) {
  const auto update = statements.use(
      "UPDATE run SET document = ?2, revision = ?3, header = ?4, services = ?5, arguments = ?6, status = ?7,"
      " outcome = ?8, fault = ?9, results = ?10, steps = ?11, chain = ?12, created = ?13, ended = ?14, imported = ?15,"
      " bytes = ?16, digest = ?17 WHERE id = ?1");
  bind_run(*update, run);
  if (update->exec() == 0) return no_run(run.id);
  return {};
}

std::string select_runs(std::string_view rest) {
  return "SELECT " + std::string(kRunColumns) + " FROM run " + std::string(rest);
}

Expected<RunRecord> find_row(SQLite::Database& file, RunId id) {
  SQLite::Statement select(file, select_runs("WHERE id = ?"));
  select.bind(1, sqlite::integer(id));
  if (select.executeStep()) return read_row(select);
  SQLite::Statement entry(file, "SELECT 1 FROM entry WHERE run = ? LIMIT 1");
  entry.bind(1, sqlite::integer(id));
  if (entry.executeStep() && !is_being_removed(file, id)) return tl::unexpected(lost_row(id));
  return no_run(id);
}

// Looks for each number once.
std::vector<RunId> lost_runs(SQLite::Database& file) {
  SQLite::Statement select(file,
                           "WITH RECURSIVE each(run) AS (SELECT min(run) FROM entry UNION ALL"
                           " SELECT (SELECT min(entry.run) FROM entry WHERE entry.run > each.run) FROM each"
                           "  WHERE each.run IS NOT NULL)"
                           " SELECT run FROM each WHERE run IS NOT NULL AND run NOT IN (SELECT id FROM run)");
  std::vector<RunId> lost;
  while (select.executeStep()) lost.push_back(static_cast<RunId>(select.getColumn(0).getInt64()));
  std::erase_if(lost, [&](RunId run) { return is_being_removed(file, run); });
  return lost;
}

Error lost_row(RunId id) { return {ErrorCode::corrupt, "the row of the run is lost", path_of(id)}; }

RunList read_rows(SQLite::Statement& select, std::size_t most) {
  RunList list;
  RunId last = 0;
  for (std::size_t count = 0; select.executeStep(); ++count) {
    if (count == most) {
      list.next = last;
      break;
    }
    last = static_cast<RunId>(select.getColumn(0).getInt64());
    if (auto run = read_row(select))
      list.runs.push_back(std::move(*run));
    else
      list.damaged.push_back({last, std::move(run).error(), is_over(select.getColumn(6).getString())});
  }
  return list;
}

Expected<RunRecord> read_row(SQLite::Statement& select) {
  RunRecord run;
  run.id = static_cast<RunId>(select.getColumn(0).getInt64());
  run.document = select.getColumn(1).getString();
  run.revision = select.getColumn(2).getInt64();
  run.header = digest_in(select, 3);
  run.services = digest_in(select, 4);
  if (const Value arguments = read_value(select.getColumn(5)); arguments.is_dict()) run.arguments = arguments.as_dict();
  run.status = select.getColumn(6).getString();
  run.outcome = select.getColumn(7).getString();
  run.fault = read_value(select.getColumn(8));
  run.results = read_value(select.getColumn(9));
  run.steps = static_cast<std::uint64_t>(select.getColumn(10).getInt64());
  run.chain = digest_in(select, 11);
  run.created_ms = select.getColumn(12).getInt64();
  run.ended_ms = select.getColumn(13).getInt64();
  run.imported = select.getColumn(14).getInt() != 0;
  run.bytes = static_cast<std::uint64_t>(select.getColumn(15).getInt64());
  if (digest_in(select, 16) != digest_of(run))
    return unexpected(ErrorCode::corrupt, "the stored run is damaged", path_of(run.id));
  return run;
}

}  // namespace race::server
