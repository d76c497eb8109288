#include "server/store/journal_writer.h"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "core/value/json.h"
#include "server/store/journal_chain.h"
#include "server/store/run_checkpoints.h"
#include "server/store/run_entries.h"
#include "server/store/run_row.h"
#include "services/sqlite/file.h"
#include "services/sqlite/write_transaction.h"

namespace race::server {

namespace {

void write_entry_of(SQLite::Database& file, RunRecord& run, const execution::JournalEntry& entry) {
  const std::string input = input_text(entry);
  run.chain = chain_after(run.chain, input);
  write_entry(file, run.id, ++run.steps, input, run.chain);
  run.bytes += input.size() + run.chain.size();
}

// Of the old ones, those at today's interval are kept.
void write_checkpoint_of(SQLite::Database& file, RunRecord& run, const Value& checkpoint) {
  const std::string text = to_json(checkpoint);
  if (text.size() > RunJournal::kCheckpointBytes) return;
  write_checkpoint(file, run.id, run.steps, text);
  run.bytes += text.size();
  SQLite::Statement thin(file, "DELETE FROM checkpoint WHERE run = ? AND position % ? != 0");
  thin.bind(1, static_cast<std::int64_t>(run.id));
  thin.bind(2, static_cast<std::int64_t>(RunJournal::interval_at(run.steps)));
  thin.exec();
}

void end_run(RunRecord& run, const RunEnd& end) {
  run.status = end.status;
  run.outcome = end.outcome;
  run.fault = end.fault;
  run.results = end.results;
  run.ended_ms = end.ended_ms;
}

/// A run that is written to is under way, unless this is its end.
void write_record(SQLite::Database& file, RunRecord& run, const JournalRecord& record) {
  if (!record.entry && !record.end) {  // it is resumed. SQLite writes nothing for a row that stays as it is
    run.status = "interrupted";
    update_row(file, run);
  }
  run.status = "running";
  if (record.entry) write_entry_of(file, run, *record.entry);
  if (record.checkpoint) write_checkpoint_of(file, run, *record.checkpoint);
  if (record.end) end_run(run, *record.end);
}

}  // namespace

std::uint64_t RunJournal::interval_at(std::uint64_t position) {
  return kInterval * std::bit_ceil(std::max<std::uint64_t>(1, (position - 1) / (kInterval * kCheckpoints) + 1));
}

Expected<std::unique_ptr<JournalWriter>> JournalWriter::open(const std::string& path) try {
  return std::unique_ptr<JournalWriter>(new JournalWriter(sqlite::open(path)));
} catch (const SQLite::Exception& exception) {
  return tl::unexpected(sqlite::error_of(exception, "cannot open the journal"));
}

JournalWriter::JournalWriter(std::unique_ptr<SQLite::Database> file)
    : file_(std::move(file)), thread_([this] { run(); }) {}

JournalWriter::~JournalWriter() { close(); }

void JournalWriter::close() {
  {
    const services::MutexLock lock(mutex_);
    closed_ = true;
  }
  appended_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void JournalWriter::append(std::shared_ptr<RunJournal> journal, JournalRecord record) {
  {
    const services::MutexLock lock(mutex_);
    if (closed_) return;
    waiting_.push_back({std::move(journal), std::move(record)});
    if (waiting_.size() > 1) return;  // who put the first one has woken it
  }
  appended_.notify_one();
}

void JournalWriter::run() {
  for (auto items = next(); !items.empty(); items = next()) write(items);
}

// All that waits; nothing: the writer ends.
std::deque<JournalWriter::Item> JournalWriter::next() {
  const services::MutexLock lock(mutex_);
  appended_.wait(mutex_, [this]() REQUIRES(mutex_) { return closed_ || !waiting_.empty(); });
  return std::exchange(waiting_, {});
}

// Those whose journal has failed before are dropped.
void JournalWriter::write(const std::deque<Item>& items) {
  std::map<RunJournal*, std::uint64_t> tickets;
  for (const Item& item : items)
    if (!item.journal->failed_) tickets[item.journal.get()] = item.record.ticket;
  std::optional<Error> failure;
  try {
    if (!tickets.empty()) commit(items);
  } catch (const SQLite::Exception& exception) {
    failure = sqlite::error_of(exception, "the journal cannot be written");
  }
  for (const auto& [journal, ticket] : tickets) {
    journal->failed_ = failure.has_value();
    const auto sink = journal->sink_.lock();
    if (!sink) continue;
    if (failure)
      sink->failed(*failure);
    else
      sink->durable(ticket);
  }
}

// One transaction, one flush.
void JournalWriter::commit(const std::deque<Item>& items) {
  SQLite::Database& file = *file_;
  sqlite::WriteTransaction transaction(file);
  std::map<RunJournal*, const RunRecord*> written;
  std::uint64_t entries = 0;
  for (const Item& item : items) {
    if (item.journal->failed_) continue;
    RunRecord& run = item.journal->record_;
    write_record(file, run, item.record);
    written[item.journal.get()] = &run;
    entries += item.record.entry ? 1 : 0;
  }
  for (const auto& [journal, run] : written) update_row(file, *run);
  transaction.commit();
  ++commits_;
  entries_ += entries;
}

}  // namespace race::server
