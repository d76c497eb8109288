#include "server/store/run_row.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/execution/journal.h"
#include "core/value/json.h"
#include "server/store/digest_column.h"

namespace race::server {
namespace {

std::int64_t number(std::uint64_t n) { return static_cast<std::int64_t>(n); }

// Fields 2 to 17 of kRunColumns.
void bind_run(SQLite::Statement& row, const RunRecord& run, const sqlite::Digest& digest) {
  row.bind(2, run.document);
  row.bind(3, run.revision);
  bind_digest(row, 4, run.header);
  bind_digest(row, 5, run.services);
  row.bind(6, to_json(run.arguments));
  row.bind(7, run.status);
  row.bind(8, run.outcome);
  row.bind(9, to_json(run.fault));
  row.bind(10, to_json(run.results));
  row.bind(11, number(run.steps));
  bind_digest(row, 12, run.chain);
  row.bind(13, run.created_ms);
  row.bind(14, run.ended_ms);
  row.bind(15, run.imported ? 1 : 0);
  row.bind(16, number(run.bytes));
  bind_digest(row, 17, digest);
}

Value read_value(const SQLite::Column& column) {
  Value value = parse_json(column.getString(), execution::kJournalLimits).value_or(Value());
  return value.freeze();
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

void write_row(SQLite::Database& file, RunRecord& run) {
  SQLite::Statement insert(file,
                           "INSERT INTO run VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14,"
                           " ?15, ?16, ?17)");  // ?1 is null: SQLite gives the number
  bind_run(insert, run, {});
  insert.exec();
  run.id = static_cast<RunId>(file.getLastInsertRowid());
  update_row(file, run);  // its digest is also of the number
}

void update_row(SQLite::Database& file, const RunRecord& run) {
  SQLite::Statement update(
      file,
      "UPDATE run SET document = ?2, revision = ?3, header = ?4, services = ?5, arguments = ?6, status = ?7,"
      " outcome = ?8, fault = ?9, results = ?10, steps = ?11, chain = ?12, created = ?13, ended = ?14, imported = ?15,"
      " bytes = ?16, digest = ?17 WHERE id = ?1");
  update.bind(1, number(run.id));
  bind_run(update, run, digest_of(run));
  update.exec();
}

std::string select_runs(std::string_view rest) {
  return "SELECT " + std::string(kRunColumns) + " FROM run " + std::string(rest);
}

Expected<RunRecord> find_row(SQLite::Database& file, RunId id) {
  SQLite::Statement select(file, select_runs("WHERE id = ?"));
  select.bind(1, number(id));
  if (!select.executeStep()) return unexpected(ErrorCode::not_found, "there is no run of this number", path_of(id));
  return read_row(select);
}

Expected<std::vector<RunRecord>> read_rows(SQLite::Statement& select) {
  std::vector<RunRecord> found;
  while (select.executeStep()) {
    ASSIGN_OR_RETURN(RunRecord run, read_row(select));
    found.push_back(std::move(run));
  }
  return found;
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
