// JournalWriter: makes entries of all journals durable on one thread: what waits when it begins the next round shares
// one transaction, so cores that are busy at once share a flush of the disk.
//
// Threads: append(), recover() and close() on any.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "core/execution/journal.h"
#include "core/value/expected.h"
#include "server/store/disk_watch.h"
#include "server/store/runs.h"
#include "server/store/statements.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

/// What a run has come to, as RunRecord has it.
struct RunEnd {
  std::string status, outcome;
  Value fault, results;
  std::int64_t ended_ms = 0;
};

/// What is stored at once: the entry of a macro step, the checkpoint after it, the end of the run; each may be absent.
struct JournalRecord {
  std::uint64_t ticket = 0;  // increases
  std::optional<execution::JournalEntry> entry = {};
  std::optional<Value> checkpoint = {};  // schemas/checkpoint.json, frozen
  std::optional<RunEnd> end = {};
  /// Why the run does not go on: when all before is stored, its journal fails with this.
  std::optional<Error> failure = {};
};

/// The journal of one run as it grows. After a failure, nothing more is written to it: a new one goes on from what is
/// stored.
class RunJournal {
 public:
  /// A checkpoint is due at multiples of this many entries, of more in a long run: it has kCheckpoints at most.
  static constexpr std::uint64_t kInterval = 1024;
  static constexpr std::uint64_t kCheckpoints = 64;
  /// One that is larger is not kept: it saves time, no more.
  static constexpr std::size_t kCheckpointBytes = std::size_t{8} << 20U;
  /// Of its entries and checkpoints: weeks of a task that is always busy. A run whose journal is full can end, no more.
  static constexpr std::uint64_t kMostBytes = std::uint64_t{16} << 30U;
  /// Of a run that has come to `position`; a power of two times kInterval.
  static std::uint64_t interval_at(std::uint64_t position);

  /// Continues the journal of `run` after its `steps` entries.
  RunJournal(RunRecord run, std::weak_ptr<RunSink> sink) : sink_(std::move(sink)), record_(std::move(run)) {}

 private:
  friend class JournalWriter;
  // All of the writer's thread.
  const std::weak_ptr<RunSink> sink_;
  RunRecord record_;  // as written last
  bool failed_ = false;
};

class JournalWriter {
 public:
  /// Writes to the store at `path` (DataFolder::store). A run whose records the disk has not taken after `timeout` is
  /// told so; one whose journal has `most_bytes` fails with `too_large`. Errors: those of sqlite::error_of.
  static Expected<std::unique_ptr<JournalWriter>> open(const std::string& path,
                                                       std::chrono::milliseconds timeout = DiskWatch::kTimeout,
                                                       std::uint64_t most_bytes = RunJournal::kMostBytes);
  ~JournalWriter();

  /// The next record of a journal. How many may wait is limited by those who append: a core stops when it is ahead.
  void append(std::shared_ptr<RunJournal> journal, JournalRecord record) EXCLUDES(mutex_);
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
    JournalRecord record;
  };
  JournalWriter(std::unique_ptr<SQLite::Database> file, std::chrono::milliseconds timeout, std::uint64_t most_bytes);
  void run();
  bool next() EXCLUDES(mutex_);
  void write();
  void fail();
  static void report(RunJournal& journal, std::uint64_t ticket, const Expected<void>& written);

  services::Mutex mutex_;
  services::ConditionVariable appended_;
  std::deque<Item> waiting_ GUARDED_BY(mutex_);
  bool closed_ GUARDED_BY(mutex_) = false;
  std::unique_ptr<Pool> recovery_ = std::make_unique<Pool>(1);
  std::deque<Item> items_;  // that are written now: of the writer's thread, as the next
  const std::unique_ptr<SQLite::Database> file_;
  Statements statements_;
  DiskWatch watch_;
  const std::uint64_t most_bytes_;  // of a journal
  std::atomic<std::uint64_t> commits_{0}, entries_{0};
  std::thread thread_;
};

}  // namespace race::server
