// JournalWriter: makes entries of all journals durable on one thread: what waits when it begins the next round shares
// one transaction, so cores that are busy at once share a flush of the disk.
//
// Threads: append(), of one journal on one at a time, recover() and close() on any.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <thread>

#include "core/value/expected.h"
#include "server/store/disk_watch.h"
#include "server/store/run_journal.h"
#include "server/store/statements.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class JournalWriter {
 public:
  /// Writes to the store at `path` (DataFolder::store). A run whose records the disk has not taken after `timeout` is
  /// told so; one whose journal has `most_bytes` fails with `too_large`. Errors: those of sqlite::error_of.
  static Expected<std::unique_ptr<JournalWriter>> open(const std::string& path,
                                                       std::chrono::milliseconds timeout = DiskWatch::kTimeout,
                                                       std::uint64_t most_bytes = RunJournal::kMostBytes);
  ~JournalWriter();

  /// The next record of a journal; its texts and hashes are made here. How many may wait is limited by those who
  /// append: a core stops when it is ahead. A checkpoint for which there is no time is left out.
  void append(std::shared_ptr<RunJournal> journal, JournalRecord record) EXCLUDES(mutex_);
  /// Of all checkpoints, in units of their values: while a large one is written, the entries of all runs wait.
  static constexpr std::size_t kCheckpointUnits = 512U << 10U;    // a second
  static constexpr std::size_t kMostCheckpointUnits = 8U << 20U;  // after a while without
  /// Does `work` on a thread of its own: what reads a journal back that has failed. The disk may keep it for long.
  void recover(Work work) EXCLUDES(mutex_);
  /// Writes what waits, and ends; what is appended later, or is to be recovered, is dropped.
  void close() EXCLUDES(mutex_);

  /// Commits so far, and entries in them.
  struct Commits {
    std::uint64_t commits = 0, entries = 0;
  };
  Commits commits() const { return {commits_, entries_}; }

 private:
  struct Item {
    std::shared_ptr<RunJournal> journal;
    PreparedRecord record;
    std::shared_ptr<RunSink> sink;  // of a failure: it hears of that, also if nobody else knows it any more
  };
  JournalWriter(std::unique_ptr<SQLite::Database> file, std::chrono::milliseconds timeout, std::uint64_t most_bytes);
  void run();
  bool next() EXCLUDES(mutex_);
  bool has_time_for(const Value& checkpoint) EXCLUDES(mutex_);
  void write();
  void fail();
  static void report(RunJournal& journal, std::uint64_t ticket, const Expected<void>& written);

  services::Mutex mutex_;
  services::ConditionVariable appended_;
  std::deque<Item> waiting_ GUARDED_BY(mutex_);
  std::chrono::steady_clock::time_point checkpoints_until_ GUARDED_BY(mutex_);  // their share of the time is used up
  bool closed_ GUARDED_BY(mutex_) = false;
  std::unique_ptr<Pool> recovery_ = std::make_unique<Pool>(1, 0, "recovery");
  std::deque<Item> items_;  // that are written now: of the writer's thread, as the next
  const std::unique_ptr<SQLite::Database> file_;
  Statements statements_;
  DiskWatch watch_;
  const std::uint64_t most_bytes_;  // of a journal
  std::atomic<std::uint64_t> commits_{0}, entries_{0};
  std::thread thread_;
};

}  // namespace race::server
