#include "server/store/run_entries.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <utility>

#include "core/value/json.h"
#include "server/store/digest_column.h"
#include "server/store/journal_chain.h"
#include "server/store/run_row.h"
#include "server/store/run_texts.h"
#include "services/sqlite/file.h"

namespace race::server {
namespace {

using execution::JournalEntry;

// A damaged position may be negative.
std::string entry_path(RunId id, std::int64_t position) { return path_of(id) + "/entries/" + std::to_string(position); }
std::string entry_path(RunId id, std::uint64_t position) { return entry_path(id, sqlite::integer(position)); }

std::vector<EntryRow> select_rows(SQLite::Database& file, RunId id, std::uint64_t from, std::uint64_t to) {
  SQLite::Statement select(file,
                           "SELECT position, input, chain FROM entry WHERE run = ? AND position BETWEEN ? AND ?"
                           " ORDER BY position");
  select.bind(1, sqlite::integer(id));
  select.bind(2, sqlite::integer(from));
  select.bind(3, sqlite::integer(to));
  std::vector<EntryRow> found;
  while (select.executeStep())
    found.push_back({static_cast<std::uint64_t>(select.getColumn(0).getInt64()), select.getColumn(1).getString(),
                     digest_in(select, 2)});
  return found;
}

// A row beyond the last entry or before the first, as a flipped bit in a key leaves one.
Expected<void> check_no_other(SQLite::Database& file, const RunRecord& run) {
  SQLite::Statement select(file,
                           "SELECT position FROM entry WHERE run = ?1 AND position < 1"
                           " UNION ALL SELECT position FROM entry WHERE run = ?1 AND position > ?2 LIMIT 1");
  select.bind(1, sqlite::integer(run.id));
  select.bind(2, sqlite::integer(run.steps));
  if (select.executeStep()) return damaged("the journal", entry_path(run.id, select.getColumn(0).getInt64()));
  return {};
}

Expected<JournalEntry> read_entry(const EntryRow& row, RunId id, const JournalEntry* before) {
  const auto json = parse_json(row.input, execution::kJournalLimits);
  if (!json) return damaged("the journal", entry_path(id, row.position));
  auto entry = execution::read_input(*json, before);
  if (!entry) {
    const Error& error = entry.error().front();
    return unexpected(ErrorCode::corrupt, "the journal is damaged: " + error.message,
                      entry_path(id, row.position) + "/" + error.path);
  }
  return std::move(*entry);
}

}  // namespace

EntryRow append_entry(RunRecord& run, const JournalEntry& entry) {
  std::string input = input_text(entry);
  run.chain = chain_after(run.chain, input);
  run.bytes += input.size() + run.chain.size();
  return {++run.steps, std::move(input), run.chain};
}

void write_entry(Statements& statements, RunId run, const EntryRow& row) {
  const auto insert = statements.use("INSERT INTO entry VALUES (?, ?, ?, ?)");
  insert->bind(1, sqlite::integer(run));
  insert->bind(2, sqlite::integer(row.position));
  insert->bind(3, row.input);
  bind_digest(*insert, 4, row.chain);
  insert->exec();
}

Expected<std::vector<EntryRow>> read_entry_rows(SQLite::Database& file, const RunRecord& run, std::uint64_t from,
                                                std::uint64_t to) {
  const std::uint64_t first = from == 1 ? 1 : from - 1;
  std::vector<EntryRow> found = select_rows(file, run.id, first, to);
  sqlite::Digest chain = {};
  for (std::uint64_t position = first; position <= to; ++position) {
    const std::size_t i = position - first;
    if (i >= found.size() || found[i].position != position) return damaged("the journal", entry_path(run.id, position));
    const EntryRow& row = found[i];
    if (position == 1) {
      ASSIGN_OR_RETURN(const Value header, read_header_text(file, run));
      chain = sqlite::sha256_of({to_json(header)});
    }
    if ((position >= from || position == 1) && row.chain != chain_after(chain, row.input))
      return damaged("the journal", entry_path(run.id, position));
    chain = row.chain;
  }
  if (to == run.steps && chain != run.chain) return damaged("the journal", entry_path(run.id, to));
  if (auto none = check_no_other(file, run); !none) return tl::unexpected(std::move(none).error());
  return found;
}

Expected<std::vector<JournalEntry>> read_entries(const std::vector<EntryRow>& rows, RunId run, std::uint64_t from) {
  std::vector<JournalEntry> entries;
  const JournalEntry some = execution::EventEntry{};  // before the row before `from`
  for (const EntryRow& each : rows) {
    const JournalEntry* before = !entries.empty() ? &entries.back() : each.position == 1 ? nullptr : &some;
    ASSIGN_OR_RETURN(JournalEntry entry, read_entry(each, run, before));
    entries.push_back(std::move(entry));
  }
  if (from > 1) entries.erase(entries.begin());
  return entries;
}

}  // namespace race::server
