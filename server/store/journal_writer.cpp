#include "server/store/journal_writer.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "server/store/run_checkpoints.h"
#include "server/store/run_entries.h"
#include "server/store/run_row.h"
#include "server/store/run_timing.h"
#include "services/failures.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"
#include "services/thread_name.h"
#include "services/time_slice.h"

namespace race::server {

namespace {

// Of the old ones, those at today's interval are kept.
void thin_checkpoints(Statements& statements, const RunRecord& run) {
  const auto thin = statements.use("DELETE FROM checkpoint WHERE run = ? AND position % ? != 0");
  thin->bind(1, static_cast<std::int64_t>(run.id));
  thin->bind(2, static_cast<std::int64_t>(RunJournal::interval_at(run.steps)));
  thin->exec();
}

/// What is written of a run at once; the records outlive it.
class Batch {
 public:
  void add(const PreparedRecord& record) { records_.push_back(&record); }

  /// Errors: `not_found`: the run is not in the store; `too_large`: its journal is full, and this is not its end.
  /// Nothing is written then.
  Expected<void> write(Statements& statements) const {
    const RunRecord& run = records_.back()->run;
    if (records_.front()->is_full && !run.is_over() && entries() > 0)
      return unexpected(ErrorCode::too_large, "the journal of the run is full; stop the run, and start another");
    if (any(&PreparedRecord::resumes)) {  // SQLite writes nothing for a row that stays as it is
      RunRecord interrupted = run;
      interrupted.status = "interrupted";
      if (auto there = update_row(statements, interrupted); !there) return there;
    }
    if (auto there = update_row(statements, run); !there) return there;
    for (const PreparedRecord* each : records_) {
      if (each->entry) write_entry(statements, run.id, *each->entry);
      if (each->checkpoint) write_checkpoint(statements, run.id, *each->checkpoint);
      if (each->timing) write_timing(statements, run.id, *each->timing);
    }
    if (any(&PreparedRecord::checkpoint)) thin_checkpoints(statements, run);
    return {};
  }

  std::uint64_t ticket() const { return records_.back()->ticket; }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(records_, [](const auto* each) { return each->entry.has_value(); }));
  }

 private:
  template <typename What>
  bool any(What what) const {
    return std::ranges::any_of(
        records_, [what](const PreparedRecord* each) { return static_cast<bool>(std::invoke(what, *each)); });
  }

  std::vector<const PreparedRecord*> records_;  // at least one
};

}  // namespace

Expected<std::unique_ptr<JournalWriter>> JournalWriter::open(const std::string& path, std::chrono::milliseconds timeout,
                                                             std::uint64_t most_bytes) try {
  return std::unique_ptr<JournalWriter>(new JournalWriter(sqlite::open(path), timeout, most_bytes));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the journal"));
}

JournalWriter::JournalWriter(std::unique_ptr<SQLite::Database> file, std::chrono::milliseconds timeout,
                             std::uint64_t most_bytes)
    : file_(std::move(file)), statements_(*file_), watch_(timeout), most_bytes_(most_bytes), thread_([this] {
        run();
      }) {}

JournalWriter::~JournalWriter() { close(); }

void JournalWriter::close() {
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
  }
  appended_.notify_one();
  if (thread_.joinable()) thread_.join();
  recovery_.reset();
}

void JournalWriter::recover(Work work) {
  const services::MutexLock lock(mutex_);
  if (!closed_) recovery_->post(std::move(work));
}

bool JournalWriter::has_time_for(const Value& checkpoint) {
  using Clock = std::chrono::steady_clock;
  const auto time_of = [](std::size_t units) {
    const std::chrono::duration<double> seconds(static_cast<double>(units) / kCheckpointUnits);
    return std::chrono::duration_cast<Clock::duration>(seconds);
  };
  const auto now = Clock::now();
  const auto cost = time_of(checkpoint.size_units());
  const services::MutexLock lock(mutex_);
  if (checkpoints_until_ > now) return false;
  checkpoints_until_ = std::max(checkpoints_until_, now - time_of(kMostCheckpointUnits));
  checkpoints_until_ += cost;
  return true;
}

void JournalWriter::append(std::shared_ptr<RunJournal> journal, JournalRecord record) {
  if (record.checkpoint && !has_time_for(*record.checkpoint)) record.checkpoint.reset();
  PreparedRecord prepared = journal->prepare(record, most_bytes_);
  {
    const services::MutexLock lock(mutex_);
    if (closed_) return;
    watch_.waits(journal.get(), journal->sink_);
    std::shared_ptr<RunSink> sink = record.failure ? journal->sink_.lock() : nullptr;
    waiting_.push_back({std::move(journal), std::move(prepared), std::move(sink)});
    if (waiting_.size() > 1) return;  // who put the first one has woken it
  }
  appended_.notify_one();
}

void JournalWriter::run() {
  services::name_thread("journal");
  services::shorten_time_slice();
  while (next()) {
    if (!services::run_reporting("the journal", [this] { write(); })) fail();
    items_.clear();
  }
}

// Such as without memory. Some may have been written: a run that hears of a failure reads back what is stored.
void JournalWriter::fail() {
  for (const Item& item : items_)
    services::run_reporting("telling that the journal fails", [&] {
      watch_.answered(item.journal.get(), 1);
      if (!item.journal->failed_) report(*item.journal, 0, unexpected(ErrorCode::storage, "the journal has failed"));
    });
}

// All that waits; false: the writer ends. Takes no memory: nobody would hear of a failure here.
bool JournalWriter::next() {
  const services::MutexLock lock(mutex_);
  appended_.wait(mutex_, [this]() REQUIRES(mutex_) { return closed_ || !waiting_.empty(); });
  items_.swap(waiting_);
  return !items_.empty();
}

// Those whose journal has failed before are dropped. One transaction, one flush.
void JournalWriter::write() {
  std::map<RunJournal*, Batch> batches;
  std::map<RunJournal*, std::size_t> records;
  for (const Item& item : items_) {
    RunJournal& journal = *item.journal;
    ++records[&journal];
    if (!journal.failed_ && !item.record.failure) batches[&journal].add(item.record);
  }
  std::map<RunJournal*, Expected<void>> written;
  if (!batches.empty()) try {
      sqlite::WriteTransaction transaction(*file_);
      std::uint64_t entries = 0;
      for (const auto& [journal, batch] : batches) {
        written[journal] = batch.write(statements_);
        if (written[journal]) entries += batch.entries();
      }
      transaction.commit();
      ++commits_;
      entries_ += entries;
    } catch (const SQLite::Exception& exception) {
      const Error error = sqlite::error_of(exception, "the journal cannot be written");
      for (const auto& [journal, batch] : batches) written[journal] = tl::unexpected(error);
    }
  // One that has failed before is told again if it was told since that the disk hangs.
  for (const auto& [journal, count] : records)
    if (watch_.answered(journal, count) && (journal->failed_ || written[journal]))
      written[journal] = unexpected(ErrorCode::storage, "the disk has answered too late");
  for (const Item& item : items_)
    if (item.record.failure) written[item.journal.get()] = tl::unexpected(*item.record.failure);
  for (const auto& [journal, outcome] : written)
    report(*journal, batches.contains(journal) ? batches.at(journal).ticket() : 0, outcome);
}

void JournalWriter::report(RunJournal& journal, std::uint64_t ticket, const Expected<void>& written) {
  journal.failed_ = !written;
  const auto sink = journal.sink_.lock();
  if (!sink) return;
  if (written)
    sink->durable(ticket);
  else
    sink->failed(written.error());
}

}  // namespace race::server
