// Runs: every run with its journal (core/SEMANTICS.md section 10) and checkpoints. What is read is held against the
// digests and the chain of hashes that were stored with it.
//
// Threads: any; one at a time inside. Entries are written by JournalWriter (journal_writer.h) on a connection of its
// own.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/execution/journal.h"
#include "core/execution/journal_source.h"
#include "core/rsm/model.h"
#include "core/value/expected.h"
#include "server/store/statements.h"
#include "server/store/timing.h"
#include "server/threads/work_progress.h"
#include "server/wire/run_status.h"
#include "services/mutex.h"
#include "services/sqlite/digest.h"

namespace race::server {

using RunId = std::uint64_t;

/// A run as it is listed.
struct RunRecord {
  RunId id = 0;
  std::string document;       // of which it was made,
  std::int64_t revision = 0;  // in this revision
  Dict arguments;
  std::string status = "ready";               // ready, running, interrupted, ended, faulted, aborted
  std::string outcome;                        // ended: the port by which the root was left
  Value fault;                                // faulted: schemas/core.json, `fault`; else null
  Value results;                              // over: of the root; else null
  std::uint64_t steps = 0;                    // entries of the journal
  sqlite::Digest chain = {};                  // of the last entry, or of the header
  sqlite::Digest header = {}, services = {};  // where their texts are stored (schema.h)
  std::int64_t created_ms = 0, ended_ms = 0;  // since 1970; 0: not yet
  bool imported = false;                      // it was executed by another server
  std::uint64_t bytes = 0;                    // of its entries and checkpoints

  bool is_over() const { return server::is_over(status); }
};

/// A run of which the row is damaged or lost; its journal may be whole.
struct DamagedRun {
  RunId id = 0;
  Error error;           // `corrupt`
  bool is_over = false;  // as far as can be read
};

struct RunList {
  std::vector<RunRecord> runs;
  std::vector<DamagedRun> damaged;
  std::optional<RunId> next;          // there are more: list() goes on before this one
  std::vector<Error> errors() const;  // of `damaged`
};

class Runs {
 public:
  /// Opens the store (DataFolder::store). Error of all: `storage`, `io`; `corrupt`, naming the run: what was stored is
  /// damaged.
  static Expected<std::unique_ptr<Runs>> open(const std::string& path);
  /// To read it alone, also while a server writes to it. Errors also: `not_found`; `version`: another version of the
  /// program wrote it.
  static Expected<std::unique_ptr<Runs>> open_to_read(const std::string& path);
  ~Runs();

  struct NewRun {
    std::string document;
    std::int64_t revision = 0;
    const execution::JournalHeader& header;
    std::map<std::string, rsm::Service> services;  // the RSMs of the moment, as one file of a run has them
  };
  /// Stores a run that has not begun and gives it its number: durable when it returns.
  Expected<RunRecord> create(const NewRun& run, std::int64_t now_ms) EXCLUDES(mutex_);
  /// The same run with another header: another model was loaded, or other arguments. Requires that it has not begun.
  Expected<RunRecord> replace(RunId id, const NewRun& run) EXCLUDES(mutex_);
  /// An executed run, whole: checked before by execution::read_journal. Gets a new number. `checkpoints`: position ->
  /// text; `timing`: what is known of its times. Stored in short transactions, between which others write; the run is
  /// there after the last one. What a failure leaves is removed when the store is opened. `stored` is how many of the
  /// entries are. Error `conflict`: a backup was restored meanwhile.
  Expected<RunRecord> import(RunRecord record, const NewRun& run, const std::vector<execution::JournalEntry>& entries,
                             const std::map<std::uint64_t, std::string>& checkpoints = {},
                             const std::vector<TimingBlock>& timing = {}, const WorkPart& stored = {}) EXCLUDES(mutex_);
  /// `imported` is called after each import, on its thread; nothing: nobody. Not during an import.
  void on_import(std::function<void()> imported) EXCLUDES(mutex_);

  /// `not_found`: there is none. `corrupt` also if its row is lost and its journal is there.
  Expected<RunRecord> get(RunId id) EXCLUDES(mutex_);
  /// The newest first, those before run `before` (0: from the newest), at most `most`, damaged ones included; of one
  /// document if it is given.
  Expected<RunList> list(RunId before, std::size_t most, const std::string& document = "") EXCLUDES(mutex_);
  /// Those that are not over and were not imported, in order of number: to be hosted when the server begins. And all
  /// that are damaged or lost.
  Expected<RunList> open_runs() EXCLUDES(mutex_);
  Expected<execution::JournalHeader> header(RunId id) EXCLUDES(mutex_);
  /// Key -> RSM (schemas/service.json), as they were when the run was created.
  Expected<Value> services(RunId id) EXCLUDES(mutex_);
  /// Entries `from` to `to`, both from 1, held against the chain. Requires that they are there.
  Expected<std::vector<execution::JournalEntry>> entries(RunId id, std::uint64_t from, std::uint64_t to)
      EXCLUDES(mutex_);
  /// The newest checkpoint at or before `position`; unknown: there is none.
  Expected<Value> checkpoint(RunId id, std::uint64_t position) EXCLUDES(mutex_);
  /// Positions of all checkpoints of a run, in order.
  Expected<std::vector<std::uint64_t>> checkpoints(RunId id) EXCLUDES(mutex_);
  /// Shows what is known of the times of a run to `take`, in order, from the block on that has macro step `from`, until
  /// it says false; `take` must be quick, and not use this. `recent`: what was not stored yet when it was read, before
  /// this (TimingRecorder::blocks).
  Expected<void> timing(RunId id, std::uint64_t from, const std::vector<TimingBlock>& recent,
                        const std::function<bool(const TimingBlock&)>& take) EXCLUDES(mutex_);
  /// The next of the times of a run. Nothing is kept of a run that is not there.
  Expected<void> add_timing(RunId id, const TimingBlock& block) EXCLUDES(mutex_);
  /// For a Replay. The run outlives it or its questions are answered `not_found`; Runs outlives it.
  std::shared_ptr<execution::JournalSource> source(RunId id);

  /// Of a run that a crash or a failing disk has interrupted. `interrupted` changes none that is over: who rebuilds a
  /// run may be late.
  Expected<void> set_status(RunId id, const std::string& status) EXCLUDES(mutex_);
  /// What each run that is over, or was imported, holds: bytes of its entries, checkpoints, samples and times. The
  /// newest first.
  Expected<std::vector<std::pair<RunId, std::uint64_t>>> sizes() EXCLUDES(mutex_);
  /// The run, its journal, its samples, its times and what no other run shares; also of one that is damaged. The run
  /// goes at once, durably; the rest in short transactions, between which others write. What a failure leaves of the
  /// rest is removed when the store is opened. `not_found`.
  Expected<void> remove(RunId id) EXCLUDES(mutex_);

 private:
  explicit Runs(std::unique_ptr<SQLite::Database> file);
  struct Import;  // run_import.cpp
  Expected<void> store(Import& import, const WorkPart& stored) EXCLUDES(mutex_);
  Expected<RunId> begin_import() EXCLUDES(mutex_);
  Expected<void> continue_import(RunId id, const std::function<void(Statements&)>& write) EXCLUDES(mutex_);
  Expected<void> remove_rest(RunId id) EXCLUDES(mutex_);
  void finish_removals() EXCLUDES(mutex_);

  services::Mutex mutex_;
  const std::unique_ptr<SQLite::Database> file_ PT_GUARDED_BY(mutex_);
  Statements statements_ GUARDED_BY(mutex_);
  std::function<void()> imported_ GUARDED_BY(mutex_);
};

}  // namespace race::server
