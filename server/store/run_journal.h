// RunJournal: the journal of a run as it grows. Texts and hashes of what is appended are made here, by who appends it,
// so that a run with much to store delays the journal of no other (journal_writer.h).
//
// Threads: prepare() on one at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/execution/journal.h"
#include "core/value/expected.h"
#include "server/store/disk_watch.h"
#include "server/store/run_checkpoints.h"
#include "server/store/run_entries.h"
#include "server/store/run_timing.h"
#include "server/store/runs.h"

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
  std::optional<TimingBlock> timing = {};  // only with one of these
  /// Alone: why the run does not go on. When all before is stored, its journal fails with this.
  std::optional<Error> failure = {};
};

/// A record as it is written.
struct PreparedRecord {
  std::uint64_t ticket = 0;
  std::optional<EntryRow> entry;
  std::optional<CheckpointRow> checkpoint;
  std::optional<TimingRow> timing;
  RunRecord run;         // after it
  bool is_full = false;  // before it
  std::optional<Error> failure;

  /// It says no more than that the run goes on.
  bool resumes() const { return !entry && !run.is_over(); }
};

/// After a failure, nothing more is written to it: a new one goes on from what is stored.
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

  /// The next record, of a journal that has at most `most_bytes`. If it throws, the record is lost, and nothing else.
  PreparedRecord prepare(const JournalRecord& record, std::uint64_t most_bytes);

 private:
  friend class JournalWriter;
  const std::weak_ptr<RunSink> sink_;
  RunRecord record_;     // as prepared last
  bool failed_ = false;  // of the writer's thread
};

}  // namespace race::server
