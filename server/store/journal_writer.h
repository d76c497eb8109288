// JournalWriter: makes entries of all journals durable on one thread: what waits when it comes round shares one
// transaction, so cores that are busy at once share a flush of the disk.
//
// Threads: append() on any; a RunSink's functions are called on the writer's thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/execution/journal.h"
#include "core/value/expected.h"
#include "server/store/runs.h"
#include "services/mutex.h"
#include "services/sqlite/digest.h"

namespace race::server {

/// Hears what became of a run's entries. Must be quick.
class RunSink {
 public:
  virtual ~RunSink() = default;
  /// Everything up to the entry at `position` is durable.
  virtual void durable(std::uint64_t position) = 0;
  /// Nothing after the last durable entry is stored, nor will be.
  virtual void failed(const Error& error) = 0;
};

/// What a run has come to, as RunRecord has it.
struct RunEnd {
  std::string status, outcome;
  Value fault, results;
  std::int64_t ended_ms = 0;
};

/// One run's way to the disk. After a failure, nothing more is written by it.
class RunJournal {
 public:
  /// Continues the journal of `run` after its `steps` entries.
  RunJournal(const RunRecord& run, std::weak_ptr<RunSink> sink)
      : run_(run.id), sink_(std::move(sink)), next_(run.steps + 1), chain_(run.chain), record_(run) {}

 private:
  friend class JournalWriter;
  const RunId run_;
  const std::weak_ptr<RunSink> sink_;
  std::uint64_t next_;    // position of the next entry, of those who append
  sqlite::Digest chain_;  // before it
  RunRecord record_;      // of the writer's thread: as stored last
  bool failed_ = false;   // of the writer's thread
};

class JournalWriter {
 public:
  /// Entries that may wait for the disk: who has more is told to wait (full()).
  static constexpr std::size_t kMostWaiting = 4096;

  /// Writes to the store at `path` (DataFolder::store). Error `io`, `storage`.
  static Expected<std::unique_ptr<JournalWriter>> open(const std::string& path);
  /// Writes what waits, and ends.
  ~JournalWriter();

  /// The next entry of a journal, with the checkpoint after its macro step and the end of the run, if there are any.
  void append(const std::shared_ptr<RunJournal>& journal, const execution::JournalEntry& entry,
              std::optional<std::string> checkpoint = {}, std::optional<RunEnd> end = {}) EXCLUDES(mutex_);
  /// Commits so far, and entries in them: how many share one.
  std::pair<std::uint64_t, std::uint64_t> commits() const { return {commits_, entries_}; }

 private:
  struct Item {
    std::shared_ptr<RunJournal> journal;
    std::uint64_t position;
    std::string input;
    sqlite::Digest chain;
    std::optional<std::string> checkpoint;
    std::optional<RunEnd> end;
  };
  explicit JournalWriter(std::unique_ptr<SQLite::Database> file);
  void run();
  std::deque<Item> next() EXCLUDES(mutex_);
  void write(std::deque<Item>& items);

  services::Mutex mutex_;
  services::ConditionVariable appended_;
  std::deque<Item> waiting_ GUARDED_BY(mutex_);
  bool stop_ GUARDED_BY(mutex_) = false;
  const std::unique_ptr<SQLite::Database> file_;  // of the writer's thread
  std::atomic<std::uint64_t> commits_{0}, entries_{0};
  std::thread thread_;
};

}  // namespace race::server
