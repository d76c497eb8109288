#include "server/store/journal_writer.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <bit>
#include <map>
#include <utility>
#include <vector>

#include "core/value/json.h"
#include "server/store/run_checkpoints.h"
#include "server/store/run_entries.h"
#include "server/store/run_row.h"
#include "services/failures.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {

namespace {

// Of the old ones, those at today's interval are kept.
void thin_checkpoints(Statements& statements, const RunRecord& run) {
  const auto thin = statements.use("DELETE FROM checkpoint WHERE run = ? AND position % ? != 0");
  thin->bind(1, static_cast<std::int64_t>(run.id));
  thin->bind(2, static_cast<std::int64_t>(RunJournal::interval_at(run.steps)));
  thin->exec();
}

void end_run(RunRecord& run, const RunEnd& end) {
  run.status = end.status;
  run.outcome = end.outcome;
  run.fault = end.fault;
  run.results = end.results;
  run.ended_ms = end.ended_ms;
}

/// What is written of a run at once. Texts and hashes are computed before the transaction begins: all who write the
/// store wait while it lasts.
class Batch {
 public:
  /// `run` as it was written last; its journal has at most `most_bytes` before.
  Batch(RunRecord& run, std::uint64_t most_bytes) : run_(run), is_full_(run.bytes >= most_bytes) {}

  /// A run that is written to is under way, unless this is its end.
  void add(const JournalRecord& record) {
    ticket_ = record.ticket;
    resumes_ |= !record.entry && !record.end;
    run_.status = "running";
    if (record.entry) entries_.push_back(append_entry(run_, *record.entry));
    if (record.checkpoint) add_checkpoint(to_json(*record.checkpoint));
    if (record.end) end_run(run_, *record.end);
    ends_ |= record.end.has_value();
  }

  /// Errors: `not_found`: the run is not in the store; `too_large`: its journal is full, and this is not its end.
  /// Nothing is written then.
  Expected<void> write(Statements& statements) const {
    if (is_full_ && !ends_ && !entries_.empty())
      return unexpected(ErrorCode::too_large, "the journal of the run is full; stop the run, and start another");
    if (resumes_) {  // SQLite writes nothing for a row that stays as it is
      RunRecord interrupted = run_;
      interrupted.status = "interrupted";
      if (auto there = update_row(statements, interrupted); !there) return there;
    }
    if (auto there = update_row(statements, run_); !there) return there;
    for (const EntryRow& entry : entries_) write_entry(statements, run_.id, entry);
    for (const CheckpointRow& checkpoint : checkpoints_) write_checkpoint(statements, run_.id, checkpoint);
    if (!checkpoints_.empty()) thin_checkpoints(statements, run_);
    return {};
  }

  std::uint64_t ticket() const { return ticket_; }
  std::size_t entries() const { return entries_.size(); }

 private:
  void add_checkpoint(std::string text) {
    if (text.size() > RunJournal::kCheckpointBytes) return;
    run_.bytes += text.size();
    checkpoints_.push_back(checkpoint_row(run_.id, run_.steps, std::move(text)));
  }

  RunRecord& run_;
  const bool is_full_;
  std::uint64_t ticket_ = 0;
  bool resumes_ = false, ends_ = false;
  std::vector<EntryRow> entries_;
  std::vector<CheckpointRow> checkpoints_;
};

}  // namespace

std::uint64_t RunJournal::interval_at(std::uint64_t position) {
  return kInterval * std::bit_ceil(std::max<std::uint64_t>(1, (position - 1) / (kInterval * kCheckpoints) + 1));
}

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

void JournalWriter::append(std::shared_ptr<RunJournal> journal, JournalRecord record) {
  {
    const services::MutexLock lock(mutex_);
    if (closed_) return;
    watch_.waits(journal.get(), journal->sink_);
    waiting_.push_back({std::move(journal), std::move(record)});
    if (waiting_.size() > 1) return;  // who put the first one has woken it
  }
  appended_.notify_one();
}

void JournalWriter::run() {
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
    if (!journal.failed_) batches.try_emplace(&journal, journal.record_, most_bytes_).first->second.add(item.record);
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
