#include "server/store/runs.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "server/store/run_checkpoints.h"
#include "server/store/run_entries.h"
#include "server/store/run_numbers.h"
#include "server/store/run_removal.h"
#include "server/store/run_row.h"
#include "server/store/run_texts.h"
#include "server/store/run_timing.h"
#include "server/store/schema.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {
namespace {

constexpr std::int64_t kMostOtherBytes = std::int64_t{1}
                                         << 29U;  // samples, pictures and times of a run; more is damage

using execution::JournalEntry;
using execution::JournalHeader;

tl::unexpected<Error> failure(const SQLite::Exception& exception, const char* what) {
  return tl::unexpected(sqlite::error_of(exception, what));
}

class StoredJournal final : public execution::JournalSource {
 public:
  StoredJournal(Runs& runs, RunId id) : runs_(runs), id_(id) {}
  Expected<std::vector<JournalEntry>> entries(std::uint64_t from, std::uint64_t to) override {
    return runs_.entries(id_, from, to);
  }
  Expected<Value> checkpoint(std::uint64_t position) override { return runs_.checkpoint(id_, position); }

 private:
  Runs& runs_;
  const RunId id_;
};

}  // namespace

Runs::Runs(std::unique_ptr<SQLite::Database> file) : file_(std::move(file)), statements_(*file_) {}
Runs::~Runs() = default;

Expected<std::unique_ptr<Runs>> Runs::open(const std::string& path) try {
  auto file = sqlite::open(path);
  if (auto done = sqlite::migrate(*file, store_migrations()); !done) return tl::unexpected(std::move(done).error());
  std::unique_ptr<Runs> runs(new Runs(std::move(file)));
  runs->finish_removals();
  return runs;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot open the runs");
}

// Nothing needs the room: a full disk does not keep a server from starting.
void Runs::finish_removals() try {
  const services::MutexLock lock(mutex_);
  server::finish_removals(*file_);
} catch (const SQLite::Exception&) {
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
  RunRecord record;
  record.created_ms = now_ms;
  const RunTexts texts = describe(run, record);
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  record.id = take_run_number(*file_);
  write_texts(statements_, record, texts);
  write_row(statements_, record);
  transaction.commit();
  return record;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store the run");
}

Expected<RunRecord> Runs::replace(RunId id, const NewRun& run) try {
  const services::MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(RunRecord record, find_row(*file_, id));
  const RunTexts texts = describe(run, record);
  sqlite::WriteTransaction transaction(*file_);
  write_texts(statements_, record, texts);
  if (auto there = update_row(statements_, record); !there) return tl::unexpected(std::move(there).error());
  remove_unused_texts(*file_);
  transaction.commit();
  return record;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store the run");
}

Expected<RunRecord> Runs::get(RunId id) try {
  const services::MutexLock lock(mutex_);
  SQLite::Transaction snapshot(*file_);
  return find_row(*file_, id);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

std::vector<Error> RunList::errors() const {
  std::vector<Error> errors;
  for (const DamagedRun& run : damaged) errors.push_back(run.error);
  return errors;
}

Expected<RunList> Runs::list(RunId before, std::size_t most, const std::string& document) try {
  const services::MutexLock lock(mutex_);
  SQLite::Transaction snapshot(*file_);
  SQLite::Statement select(
      *file_, select_runs("WHERE (?1 = 0 OR id < ?1) AND (?3 = '' OR document = ?3) ORDER BY id DESC LIMIT ?2"));
  select.bind(1, sqlite::integer(before));
  select.bind(2, sqlite::integer(most) + 1);
  select.bind(3, document);
  RunList list = read_rows(select, most);
  for (const RunId lost : lost_runs(*file_)) {  // of any document
    const bool is_here = (before == 0 || lost < before) && lost > list.next.value_or(0);
    if (is_here && list.damaged.size() < most) list.damaged.push_back({lost, lost_row(lost)});
  }
  return list;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

// What a damaged row says of its status may be wrong: all rows are read.
Expected<RunList> Runs::open_runs() try {
  const services::MutexLock lock(mutex_);
  SQLite::Transaction snapshot(*file_);
  SQLite::Statement select(*file_, select_runs("ORDER BY id"));
  RunList list = read_rows(select, kLastRunNumber);
  std::erase_if(list.runs, [](const RunRecord& run) { return run.is_over() || run.imported; });
  for (const RunId lost : lost_runs(*file_)) list.damaged.push_back({lost, lost_row(lost)});
  return list;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<JournalHeader> Runs::header(RunId id) {
  Value json;
  try {
    const services::MutexLock lock(mutex_);
    SQLite::Transaction snapshot(*file_);
    ASSIGN_OR_RETURN(const RunRecord run, find_row(*file_, id));
    ASSIGN_OR_RETURN(json, read_header_text(*file_, run));
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
  ASSIGN_OR_RETURN(const RunRecord run, find_row(*file_, id));
  return read_services_text(*file_, run);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<std::vector<JournalEntry>> Runs::entries(RunId id, std::uint64_t from, std::uint64_t to) {
  std::vector<EntryRow> found;
  try {
    const services::MutexLock lock(mutex_);
    SQLite::Transaction snapshot(*file_);
    ASSIGN_OR_RETURN(const RunRecord run, find_row(*file_, id));
    if (from < 1 || from > to || to > run.steps)
      return unexpected(ErrorCode::out_of_range, "the journal has " + std::to_string(run.steps) + " entries",
                        path_of(id) + "/entries/" + std::to_string(to));
    ASSIGN_OR_RETURN(found, read_entry_rows(*file_, run, from, to));
  } catch (const SQLite::Exception& exception) {
    return failure(exception, "cannot read runs");
  }
  return read_entries(found, id, from);
}

Expected<Value> Runs::checkpoint(RunId id, std::uint64_t position) try {
  const services::MutexLock lock(mutex_);
  return read_checkpoint(*file_, id, position);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<std::vector<std::uint64_t>> Runs::checkpoints(RunId id) try {
  const services::MutexLock lock(mutex_);
  return list_checkpoints(*file_, id);
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

// What has been stored since is among the recent ones.
Expected<void> Runs::timing(RunId id, std::uint64_t from, const std::vector<TimingBlock>& recent,
                            const std::function<bool(const TimingBlock&)>& take) try {
  bool more = true;
  {
    const services::MutexLock lock(mutex_);
    const auto read = read_timing_rows(*file_, id, from, [&](const TimingBlock& block) {
      if (!recent.empty() && block.ends > recent.front().begins) return false;
      return more = take(block);
    });
    if (!read) return read;
  }
  for (const TimingBlock& block : recent)
    if (more) more = take(block);
  return {};
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<void> Runs::add_timing(RunId id, const TimingBlock& block) try {
  const TimingRow row = timing_row(block);
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  if (!find_row(*file_, id)) return {};
  write_timing(statements_, id, row);
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store times");
}

std::shared_ptr<execution::JournalSource> Runs::source(RunId id) { return std::make_shared<StoredJournal>(*this, id); }

Expected<void> Runs::set_status(RunId id, const std::string& status) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  ASSIGN_OR_RETURN(RunRecord record, find_row(*file_, id));
  if (record.is_over() && status == "interrupted") return {};
  record.status = status;
  if (auto there = update_row(statements_, record); !there) return there;
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot store the run");
}

Expected<std::vector<std::pair<RunId, std::uint64_t>>> Runs::sizes() try {
  const services::MutexLock lock(mutex_);
  SQLite::Statement select(*file_, "SELECT " + std::string(kRunColumns) +
                                       ", coalesce((SELECT bytes FROM sampling WHERE run = id), 0) +"
                                       " coalesce((SELECT bytes FROM picturing WHERE run = id), 0) +"
                                       " coalesce((SELECT sum(bytes) FROM timing WHERE run = id), 0) FROM run"
                                       " WHERE status IN ('ended', 'faulted', 'aborted') OR imported ORDER BY id DESC");
  const int others = 17;  // the column after those of read_row()
  std::vector<std::pair<RunId, std::uint64_t>> found;
  while (select.executeStep()) {
    const auto run = read_row(select);
    if (!run) {  // what a damaged row says of its size counts for nothing; it may be of a run that is not over
      if (!is_over(select.getColumn(6).getString())) continue;
      found.emplace_back(select.getColumn(0).getInt64(), 0);
      continue;
    }
    const std::int64_t bytes = std::clamp<std::int64_t>(select.getColumn(others).getInt64(), 0, kMostOtherBytes);
    found.emplace_back(run->id, run->bytes + static_cast<std::uint64_t>(bytes));
  }
  return found;
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot read runs");
}

Expected<void> Runs::remove(RunId id) {
  try {
    const services::MutexLock lock(mutex_);
    sqlite::WriteTransaction transaction(*file_);
    const auto record = find_row(*file_, id);
    if (!record && record.error().code != ErrorCode::corrupt) return tl::unexpected(record.error());
    begin_removal(*file_, id);
    const auto remove = statements_.use("DELETE FROM run WHERE id = ?");
    remove->bind(1, sqlite::integer(id));
    remove->exec();
    remove_unused_texts(*file_);
    transaction.commit();
  } catch (const SQLite::Exception& exception) {
    return failure(exception, "cannot remove the run");
  }
  std::ignore = remove_rest(id);  // the run is gone; what a disk keeps of it is removed when the store is opened
  return {};
}

Expected<void> Runs::remove_rest(RunId id) try {
  for (bool more = true; more;) {
    const services::MutexLock lock(mutex_);
    more = remove_some(*file_, id);
  }
  return {};
} catch (const SQLite::Exception& exception) {
  return failure(exception, "cannot remove the rest of the run");
}

}  // namespace race::server
