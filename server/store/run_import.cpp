// Runs::import: a run that comes whole is stored under a number that is taken first, and named in `removal` until its
// row is written: what an interruption leaves is removed like the rest of any other run (run_removal.h).
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "server/store/run_checkpoints.h"
#include "server/store/run_entries.h"
#include "server/store/run_numbers.h"
#include "server/store/run_removal.h"
#include "server/store/run_row.h"
#include "server/store/run_texts.h"
#include "server/store/run_timing.h"
#include "server/store/runs.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {

// Computed before the first transaction: all who write the store wait while one lasts.
struct Runs::Import {
  RunRecord record;
  RunTexts texts;
  std::vector<EntryRow> entries;
  std::vector<CheckpointRow> checkpoints;
  std::vector<TimingRow> timing;
};

Expected<RunRecord> Runs::import(RunRecord record, const NewRun& run,
                                 const std::vector<execution::JournalEntry>& entries,
                                 const std::map<std::uint64_t, std::string>& checkpoints,
                                 const std::vector<TimingBlock>& timing, const WorkPart& stored) {
  Import import{.record = std::move(record), .texts = {}, .entries = {}, .checkpoints = {}, .timing = {}};
  import.texts = describe(run, import.record);
  import.record.imported = true;
  import.record.steps = 0;
  import.record.bytes = 0;
  for (const execution::JournalEntry& entry : entries) import.entries.push_back(append_entry(import.record, entry));
  for (const TimingBlock& block : timing) import.timing.push_back(timing_row(block));
  ASSIGN_OR_RETURN(import.record.id, begin_import());
  for (const auto& [position, text] : checkpoints) {
    import.record.bytes += text.size();
    import.checkpoints.push_back(checkpoint_row(import.record.id, position, text));
  }
  if (auto done = store(import, stored); !done) {
    std::ignore = remove_rest(import.record.id);  // else when the store is opened
    return tl::unexpected(std::move(done).error());
  }
  std::function<void()> imported;
  {
    const services::MutexLock lock(mutex_);
    imported = imported_;
  }
  if (imported) imported();
  return std::move(import.record);
}

Expected<void> Runs::store(Import& import, const WorkPart& stored) {
  const RunRecord& run = import.record;
  std::span<const EntryRow> entries = import.entries;
  Expected<void> done;
  while (done && !entries.empty()) {
    const auto block = entries.first(std::min(kRunRowsAtOnce, entries.size()));
    entries = entries.subspan(block.size());
    done = continue_import(run.id, [&](Statements& statements) {
      for (const EntryRow& row : block) write_entry(statements, run.id, row);
    });
    if (done) stored.reach(import.entries.size() - entries.size(), import.entries.size());
  }
  for (const CheckpointRow& row : import.checkpoints)
    if (done) done = continue_import(run.id, [&](Statements& to) { write_checkpoint(to, run.id, row); });
  for (const TimingRow& row : import.timing)
    if (done) done = continue_import(run.id, [&](Statements& to) { write_timing(to, run.id, row); });
  if (!done) return done;
  return continue_import(run.id, [&](Statements& statements) {
    write_texts(statements, run, import.texts);
    write_row(statements, run);
    end_removal(statements.file(), run.id);
  });
}

Expected<RunId> Runs::begin_import() try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  const RunId id = take_run_number(*file_);
  begin_removal(*file_, id);
  transaction.commit();
  return id;
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store the run"));
}

// A store that a backup has replaced does not know this import.
Expected<void> Runs::continue_import(RunId id, const std::function<void(Statements&)>& write) try {
  const services::MutexLock lock(mutex_);
  sqlite::WriteTransaction transaction(*file_);
  if (!is_being_removed(*file_, id))
    return unexpected(ErrorCode::conflict, "a backup was restored while the run was imported", path_of(id));
  write(statements_);
  transaction.commit();
  return {};
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot store the run"));
}

void Runs::on_import(std::function<void()> imported) {
  const services::MutexLock lock(mutex_);
  imported_ = std::move(imported);
}

}  // namespace race::server
