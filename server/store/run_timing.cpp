#include "server/store/run_timing.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/run_row.h"
#include "services/sqlite/file.h"

namespace race::server {
namespace {

sqlite::Digest timing_digest(RunId run, std::int64_t number, std::int64_t last, const std::string& text) {
  return sqlite::sha256_of({"timing", std::to_string(run), std::to_string(number), std::to_string(last), text});
}

std::int64_t next_timing_number(Statements& statements, RunId run) {
  const auto select = statements.use("SELECT coalesce(max(number), 0) + 1 FROM timing WHERE run = ?");
  select->bind(1, sqlite::integer(run));
  select->executeStep();
  return select->getColumn(0).getInt64();
}

void forget_oldest_timing(Statements& statements, RunId run, std::int64_t number) {
  const auto forget = statements.use("DELETE FROM timing WHERE run = ? AND number <= ?");
  forget->bind(1, sqlite::integer(run));
  forget->bind(2, number - static_cast<std::int64_t>(TimingBlock::kMostBlocks));
  forget->exec();
}

}  // namespace

TimingRow timing_row(const TimingBlock& block) { return {block.last(), to_json(timing_json(block))}; }

void write_timing(Statements& statements, RunId run, const TimingRow& row) {
  const std::int64_t number = next_timing_number(statements, run);
  const auto last = static_cast<std::int64_t>(row.last);
  const auto insert = statements.use("INSERT INTO timing VALUES (?, ?, ?, ?, ?, ?)");
  insert->bind(1, sqlite::integer(run));
  insert->bind(2, number);
  insert->bind(3, last);
  insert->bind(4, sqlite::integer(row.text.size()));
  insert->bind(5, row.text);
  bind_digest(*insert, 6, timing_digest(run, number, last, row.text));
  insert->exec();
  forget_oldest_timing(statements, run, number);
}

Expected<void> read_timing_rows(SQLite::Database& file, RunId run, std::uint64_t from,
                                const std::function<bool(const TimingBlock&)>& take) {
  SQLite::Statement select(
      file, "SELECT number, last, text, digest FROM timing WHERE run = ? AND last >= ? ORDER BY last, number");
  select.bind(1, sqlite::integer(run));
  select.bind(2, sqlite::integer(from));
  while (select.executeStep()) {
    const std::int64_t number = select.getColumn(0).getInt64();
    const std::string path = path_of(run) + "/timing/" + std::to_string(number);
    const std::string text = select.getColumn(2).getString();
    const auto json = parse_json(text, execution::kJournalLimits);
    if (digest_in(select, 3) != timing_digest(run, number, select.getColumn(1).getInt64(), text) || !json)
      return damaged("what is known of times", path);
    std::vector<Error> errors;
    const TimingBlock block = read_timing(*json, path, errors);
    if (!errors.empty()) return damaged("what is known of times", path);
    if (!take(block)) break;
  }
  return {};
}

}  // namespace race::server
