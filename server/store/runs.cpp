#include "server/store/runs.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/rsm/document.h"
#include "core/value/json.h"
#include "server/store/journal_chain.h"
#include "server/store/run_row.h"
#include "server/store/schema.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

constexpr std::int64_t kMostSampleBytes = std::int64_t{1} << 28U;  // of a run; more is damage

using execution::JournalEntry;
using execution::JournalHeader;

std::int64_t number(std::uint64_t n) { return static_cast<std::int64_t>(n); }

std::string path_of(RunId id) { return "runs/" + std::to_string(id); }
std::string path_of(RunId id, std::uint64_t position) { return path_of(id) + "/entries/" + std::to_string(position); }

tl::unexpected<Error> corrupt(const std::string& what, std::string path) {
  return unexpected(ErrorCode::corrupt, what + " is damaged", std::move(path));
}

tl::unexpected<Error> failure(const SQLite::Exception& exception, const char* what) {
  return tl::unexpected(sqlite::error_of(exception, what));
}

// ---- Texts that runs share: headers without arguments, RSMs.

std::string text_without_arguments(const JournalHeader& header) {
  Value json = execution::header_json(header);
  json.mutable_dict().erase("arguments");
  return to_json(json);
}

std::string text_of(const std::map<std::string, rsm::Service>& services) {
  Dict json;
  for (const auto& [key, service] : services) json.set(key, rsm::write_service(service));
  return to_json(std::move(json));
}

// One that was damaged is whole again when it is stored again.
sqlite::Digest write_text(SQLite::Database& file, const std::string& text) {
  const sqlite::Digest digest = sqlite::sha256(text);
  SQLite::Statement insert(file,
                           "INSERT INTO header VALUES (?, ?)"
                           " ON CONFLICT DO UPDATE SET text = excluded.text WHERE text <> excluded.text");
  bind_digest(insert, 1, digest);
  insert.bind(2, text);
  insert.exec();
  return digest;
}

Expected<Value> read_text(SQLite::Database& file, const sqlite::Digest& digest, RunId id, const char* what) {
  SQLite::Statement select(file, "SELECT text FROM header WHERE digest = ?");
  bind_digest(select, 1, digest);
  if (!select.executeStep()) return corrupt(what, path_of(id));
  const std::string text = select.getColumn(0).getString();
  if (sqlite::sha256(text) != digest) return corrupt(what, path_of(id));
  return parse_json(text, execution::kJournalLimits);
}

void remove_unused_texts(SQLite::Database& file) {
  file.exec("DELETE FROM header WHERE digest NOT IN (SELECT header FROM run UNION ALL SELECT services FROM run)");
}

void remove_rows(SQLite::Database& file, const char* statement, RunId id) {
  SQLite::Statement remove(file, statement);
  remove.bind(1, number(id));
  remove.exec();
}

// ---- Rows of runs.

Expected<std::vector<RunRecord>> rows(SQLite::Statement& select) {
  std::vector<RunRecord> found;
  while (select.executeStep()) {
    ASSIGN_OR_RETURN(RunRecord run, read_row(select));
    found.push_back(std::move(run));
  }
  return found;
}

std::string select_runs(std::string_view rest) {
  return "SELECT " + std::string(kRunColumns) + " FROM run " + std::string(rest);
}

Expected<RunRecord> row(SQLite::Database& file, RunId id) {
  SQLite::Statement select(file, select_runs("WHERE id = ?"));
  select.bind(1, number(id));
  if (!select.executeStep()) return unexpected(ErrorCode::not_found, "there is no run of this number", path_of(id));
  return read_row(select);
}

// What a run has of its header, in the record.
void describe(SQLite::Database& file, const Runs::NewRun& run, RunRecord& record) {
  record.document = run.document;
  record.revision = run.revision;
  record.arguments = run.header.arguments;
  record.chain = header_chain(run.header);
  record.header = write_text(file, text_without_arguments(run.header));
  record.services = write_text(file, text_of(run.services));
}

// schemas/journal.json, `header`: its fields in the order in which they are hashed.
Expected<Value> header_of(SQLite::Database& file, const RunRecord& run) {
  ASSIGN_OR_RETURN(const Value text, read_text(file, run.header, run.id, "the header"));
  Dict header;
  for (const auto& [key, value] : text.as_dict()) {
    header.set(key, value);
    if (key == Value("native")) header.set("arguments", run.arguments);
  }
  return Value(std::move(header));
}

// ---- Entries, held against the chain.

struct EntryRow {
  std::uint64_t position;
  std::string input;
  sqlite::Digest chain;
};

std::vector<EntryRow> entry_rows(SQLite::Database& file, RunId id, std::uint64_t from, std::uint64_t to) {
  SQLite::Statement select(file,
                           "SELECT position, input, chain FROM entry WHERE run = ? AND position BETWEEN ? AND ?"
                           " ORDER BY position");
  select.bind(1, number(id));
  select.bind(2, number(from));
  select.bind(3, number(to));
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
  select.bind(1, number(run.id));
  select.bind(2, number(run.steps));
  if (select.executeStep())
    return corrupt("the journal", path_of(run.id) + "/entries/" + select.getColumn(0).getString());
  return {};
}

/// The rows `from` - 1 (if there is one) to `to`, unless one is missing or is not as the chain has it.
Expected<std::vector<EntryRow>> checked_rows(SQLite::Database& file, const RunRecord& run, std::uint64_t from,
                                             std::uint64_t to) {
  const std::uint64_t first = from == 1 ? 1 : from - 1;
  std::vector<EntryRow> found = entry_rows(file, run.id, first, to);
  sqlite::Digest chain = {};
  for (std::uint64_t position = first; position <= to; ++position) {
    const std::size_t i = position - first;
    if (i >= found.size() || found[i].position != position) return corrupt("the journal", path_of(run.id, position));
    const EntryRow& row = found[i];
    if (position == 1) {
      ASSIGN_OR_RETURN(const Value header, header_of(file, run));
      chain = sqlite::sha256_of({to_json(header)});
    }
    if ((position >= from || position == 1) && row.chain != chain_after(chain, row.input))
      return corrupt("the journal", path_of(run.id, position));
    chain = row.chain;
  }
  if (to == run.steps && chain != run.chain) return corrupt("the journal", path_of(run.id, to));
  if (auto none = check_no_other(file, run); !none) return tl::unexpected(std::move(none).error());
  return found;
}

Expected<JournalEntry> read_entry(const EntryRow& row, RunId id, const JournalEntry* before,
                                  const semantics::Program& program) {
  const auto json = parse_json(row.input, execution::kJournalLimits);
  if (!json) return corrupt("the journal", path_of(id, row.position));
  auto entry = execution::read_input(*json, before, program);
  if (!entry) {
    const Error& error = entry.error().front();
    return unexpected(ErrorCode::corrupt, "the journal is damaged: " + error.message,
                      path_of(id, row.position) + "/" + error.path);
  }
  return std::move(*entry);
}

class StoredJournal final : public execution::JournalSource {
 public:
  StoredJournal(Runs& runs, RunId id, std::shared_ptr<const semantics::Program> program)
      : runs_(runs), id_(id), program_(std::move(program)) {}
  Expected<std::vector<JournalEntry>> entries(std::uint64_t from, std::uint64_t to) override {
    return runs_.entries(id_, *program_, from, to);
  }
  Expected<Value> checkpoint(std::uint64_t position) override { return runs_.checkpoint(id_, position); }

 private:
  Runs& runs_;
  const RunId id_;
  const std::shared_ptr<const semantics::Program> program_;
};

}  // namespace

Runs::Runs(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)) {}
Runs::~Runs() = default;

Expected<std::unique_ptr<Runs>> Runs::open(const std::string& path) try {
  auto file = sqlite::open(path);
  if (auto done = sqlite::migrate(*file, store_migrations()); !done) return tl::unexpected(std::move(done).error());
  return std::unique_ptr<Runs>(new Runs(std::move(file)));
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot open the runs");
}

Expected<std::unique_ptr<Runs>> Runs::open_to_read(const std::string& path) try {
  if (!std::filesystem::exists(path)) return unexpected(ErrorCode::not_found, "there is no store", path);
  auto file = sqlite::open_to_read(path);
  if (file->execAndGet("PRAGMA user_version").getInt() != static_cast<int>(store_migrations().size()))
    return unexpected(ErrorCode::version, "another version of the program wrote this file", path);
  return std::unique_ptr<Runs>(new Runs(std::move(file)));
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot open the runs");
}

Expected<RunRecord> Runs::create(const NewRun& run, std::int64_t now_ms) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  RunRecord record;
  record.created_ms = now_ms;
  describe(*file_, run, record);
  write_row(*file_, record);
  transaction.commit();
  return record;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store the run");
}

Expected<RunRecord> Runs::replace(RunId id, const NewRun& run) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  ASSIGN_OR_RETURN(RunRecord record, row(*file_, id));
  describe(*file_, run, record);
  update_row(*file_, record);
  remove_unused_texts(*file_);
  transaction.commit();
  return record;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store the run");
}

Expected<RunRecord> Runs::import(RunRecord record, const NewRun& run, const std::vector<JournalEntry>& entries,
                                 const std::map<std::uint64_t, std::string>& checkpoints) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  describe(*file_, run, record);
  record.imported = true;
  record.steps = 0;
  record.bytes = 0;
  write_row(*file_, record);
  for (const JournalEntry& entry : entries) {
    const std::string input = input_text(entry);
    record.chain = chain_after(record.chain, input);
    record.bytes += input.size();
    write_entry(*file_, record.id, ++record.steps, input, record.chain);
  }
  for (const auto& [position, text] : checkpoints) {
    record.bytes += text.size();
    write_checkpoint(*file_, record.id, position, text);
  }
  update_row(*file_, record);
  transaction.commit();
  return record;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store the run");
}

Expected<RunRecord> Runs::get(RunId id) try {
  const services::MutexLock lock(mutex_);
  return row(*file_, id);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<std::vector<RunRecord>> Runs::list(RunId before, std::size_t most, const std::string& document) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(
      *file_, select_runs("WHERE (?1 = 0 OR id < ?1) AND (?3 = '' OR document = ?3) ORDER BY id DESC LIMIT ?2"));
  select.bind(1, number(before));
  select.bind(2, number(most));
  select.bind(3, document);
  return rows(select);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<std::vector<RunRecord>> Runs::open_runs() try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(
      *file_, select_runs("WHERE status NOT IN ('ended', 'faulted', 'aborted') AND imported = 0 ORDER BY id"));
  return rows(select);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<JournalHeader> Runs::header(RunId id) {
  Value json;
  try {
    const services::MutexLock lock(mutex_);
    SQLite::Transaction snapshot(*file_);
    ASSIGN_OR_RETURN(const RunRecord run, row(*file_, id));
    ASSIGN_OR_RETURN(json, header_of(*file_, run));
  } catch (const SQLite::Exception& exception) {
    return failure(exception, "cannot read runs");
  }
  auto header = execution::read_header(json);
  if (header) return std::move(*header);
  Error error = std::move(header.error().front());  // of another version of core/SEMANTICS.md
  error.path = path_of(id) + "/" + error.path;
  return tl::unexpected(std::move(error));
}

Expected<Value> Runs::services(RunId id) try {
  const services::MutexLock lock(mutex_);
  SQLite::Transaction snapshot(*file_);
  ASSIGN_OR_RETURN(const RunRecord run, row(*file_, id));
  return read_text(*file_, run.services, id, "the list of services");
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<std::vector<JournalEntry>> Runs::entries(RunId id, const semantics::Program& program, std::uint64_t from,
                                                  std::uint64_t to) {
  std::vector<EntryRow> found;
  try {
    const services::MutexLock lock(mutex_);
    SQLite::Transaction snapshot(*file_);
    ASSIGN_OR_RETURN(const RunRecord run, row(*file_, id));
    if (from < 1 || from > to || to > run.steps)
      return unexpected(ErrorCode::out_of_range, "the journal has " + std::to_string(run.steps) + " entries",
                        path_of(id, to));
    ASSIGN_OR_RETURN(found, checked_rows(*file_, run, from, to));
  } catch (const SQLite::Exception& exception) {
    return failure(exception, "cannot read runs");
  }
  std::vector<JournalEntry> entries;
  const JournalEntry some = execution::EventEntry{};  // before the row before `from`
  for (const EntryRow& each : found) {
    const JournalEntry* before = !entries.empty() ? &entries.back() : each.position == 1 ? nullptr : &some;
    ASSIGN_OR_RETURN(JournalEntry entry, read_entry(each, id, before, program));
    entries.push_back(std::move(entry));
  }
  if (from > 1) entries.erase(entries.begin());
  return entries;
}

Expected<Value> Runs::checkpoint(RunId id, std::uint64_t position) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_,
                           "SELECT position, text, digest FROM checkpoint WHERE run = ? AND position <= ?"
                           " ORDER BY position DESC LIMIT 1");
  select.bind(1, number(id));
  select.bind(2, number(position));
  if (!select.executeStep()) return Value::unknown();
  const auto found = static_cast<std::uint64_t>(select.getColumn(0).getInt64());
  const std::string text = select.getColumn(1).getString();
  const std::string path = path_of(id) + "/checkpoints/" + std::to_string(found);
  if (digest_in(select, 2) != checkpoint_digest(id, found, text)) return corrupt("a checkpoint", path);
  return parse_json(text, execution::kJournalLimits);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<std::vector<std::uint64_t>> Runs::checkpoints(RunId id) try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_, "SELECT position FROM checkpoint WHERE run = ? ORDER BY position");
  select.bind(1, number(id));
  std::vector<std::uint64_t> positions;
  while (select.executeStep()) positions.push_back(static_cast<std::uint64_t>(select.getColumn(0).getInt64()));
  return positions;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

std::shared_ptr<execution::JournalSource> Runs::source(RunId id, std::shared_ptr<const semantics::Program> program) {
  return std::make_shared<StoredJournal>(*this, id, std::move(program));
}

Expected<void> Runs::set_status(RunId id, const std::string& status) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  ASSIGN_OR_RETURN(RunRecord record, row(*file_, id));
  record.status = status;
  update_row(*file_, record);
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store the run");
}

Expected<std::vector<std::pair<RunId, std::uint64_t>>> Runs::sizes() try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_, "SELECT " + std::string(kRunColumns) +
                                       ", coalesce((SELECT bytes FROM sampling WHERE run = id), 0) FROM run"
                                       " WHERE status IN ('ended', 'faulted', 'aborted') OR imported ORDER BY id DESC");
  const int sampled = 17;  // the column after those of read_row()
  std::vector<std::pair<RunId, std::uint64_t>> found;
  while (select.executeStep()) {
    const auto run = read_row(select);
    if (!run) {  // what a damaged row says of its size counts for nothing
      found.emplace_back(select.getColumn(0).getInt64(), 0);
      continue;
    }
    const std::int64_t bytes = std::clamp<std::int64_t>(select.getColumn(sampled).getInt64(), 0, kMostSampleBytes);
    found.emplace_back(run->id, run->bytes + static_cast<std::uint64_t>(bytes));
  }
  return found;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<void> Runs::remove(RunId id) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  const auto record = row(*file_, id);
  if (!record && record.error().code != ErrorCode::corrupt) return tl::unexpected(record.error());
  for (const char* rows :
       {"DELETE FROM entry WHERE run = ?", "DELETE FROM checkpoint WHERE run = ?", "DELETE FROM sample WHERE run = ?",
        "DELETE FROM sampling WHERE run = ?", "DELETE FROM run WHERE id = ?"})
    remove_rows(*file_, rows, id);
  remove_unused_texts(*file_);
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot remove the run");
}

}  // namespace race::server
