// RunQueue: runs that wait their turn. The first begins when the one before it is over; what ends other than it should
// pauses the queue (README.md). In memory alone: a server begins with none.
//
// Threads: any; quick, but for a thread of its own on which cores are made.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/control/control.h"
#include "server/execution/cores.h"
#include "server/queue/queued_run.h"
#include "server/store/documents.h"
#include "server/stream/requests.h"
#include "server/threads/strand.h"
#include "services/mutex.h"

namespace race::server {

class RunQueue {
 public:
  static constexpr std::size_t kMostWaiting = 100;
  static constexpr std::size_t kMostOver = 100;                  // that are shown after they are over; the oldest go
  static constexpr std::size_t kMostArgumentUnits = 64U << 10U;  // of the arguments of one (Value::size_units)
  static constexpr std::size_t kLongestName = 100;               // bytes

  /// All outlive this. `records`: whether who queued a run still is who they were, and for the audit log.
  RunQueue(const Control& control, Documents& documents, Cores& cores, ClientRecords& records)
      : control_(control), documents_(documents), cores_(cores), records_(records) {}

  /// Queues a run; it begins at once if none is before it. Errors: `conflict`: kMostWaiting wait, or a backup was
  /// restored since restores() was asked for the task; `too_large`: kMostArgumentUnits. Its document, revision and
  /// arguments were checked (Cores::check).
  Expected<QueuedRun> add(QueuedTask task) EXCLUDES(mutex_);
  /// How often the store has become another one.
  std::uint64_t restores() const EXCLUDES(mutex_);
  /// `not_found`: there is none of this id, or it was long ago.
  Expected<QueuedRun> find(const std::string& id) const EXCLUDES(mutex_);
  /// One that waits never begins. Errors: `not_found`; `conflict`: it does not wait.
  Expected<QueuedRun> cancel(const std::string& id) EXCLUDES(mutex_);
  /// Goes on after a pause; one that is not paused goes on as it is. Error `stopped`: the cell is.
  Expected<void> resume() EXCLUDES(mutex_);
  /// schemas/queue.json: at most `most` with ids after `after`, in their order.
  Value json(std::int64_t after, std::size_t most) const EXCLUDES(mutex_);

  /// A core has changed (schemas/core.json) or, null, was removed. Quick.
  void core_changed(const std::string& id, const Value& core) EXCLUDES(mutex_);
  /// All that waits is cancelled, and what is being begun is refused: the store has become another one. To be called
  /// while no core can be created.
  void cancel_all() EXCLUDES(mutex_);
  /// Nothing begins any more: the server ends. Waits for nothing.
  void close() EXCLUDES(mutex_);
  /// close(), and waits for what is being begun.
  void end();

 private:
  /// Why nothing begins until somebody resumes.
  struct Pause {
    std::string reason;    // "faulted", "aborted", "refused", "stopped"
    std::string run = {};  // after which; empty: none
  };
  using Entries = std::deque<QueuedRun>;
  Entries::const_iterator find_run(const std::string& id) const REQUIRES(mutex_);
  QueuedRun* current() REQUIRES(mutex_);
  std::size_t count(QueuedStatus status) const REQUIRES(mutex_);
  void forget_oldest() REQUIRES(mutex_);
  void post_next() {
    pool_.post([this] { begin_next(); });
  }
  void begin_next();
  std::optional<QueuedRun> take_next() EXCLUDES(mutex_);
  void begin(const QueuedRun& run);
  Checked<std::shared_ptr<Core>> create_core(const QueuedTask& task);
  bool has_lost_controls(const QueuedTask& task) const;
  /// The core of the run that is being begun. Errors: `conflict`: it is of a store that is no more; `stopped`, also if
  /// that is reset; `leased`: who queued it has lost the controls.
  Expected<void> set_core(const std::shared_ptr<Core>& core) EXCLUDES(mutex_);
  void begun(const QueuedRun& run, const std::shared_ptr<Core>& core, const Expected<Value>& started);
  void give_up(const QueuedRun& run, const std::shared_ptr<Core>& core, Error why);
  void refuse(const QueuedRun& run, std::vector<Error> errors) EXCLUDES(mutex_);
  void record(const QueuedRun& run, std::string outcome);

  const Control& control_;
  Documents& documents_;
  Cores& cores_;
  ClientRecords& records_;
  mutable services::Mutex mutex_;    // the control's may be taken under it
  Entries runs_ GUARDED_BY(mutex_);  // in order of their ids
  std::int64_t last_id_ GUARDED_BY(mutex_) = 0;
  std::int64_t current_ GUARDED_BY(mutex_) = 0;    // that runs, or is being begun; 0: none
  std::shared_ptr<Core> core_ GUARDED_BY(mutex_);  // its core; empty: none yet
  std::uint64_t restores_ GUARDED_BY(mutex_) = 0;
  std::uint64_t stops_ GUARDED_BY(mutex_) = 0;  // Control::stops() when it was idle or resumed last
  std::optional<Pause> pause_ GUARDED_BY(mutex_);
  bool closed_ GUARDED_BY(mutex_) = false;
  Pool pool_{1, 0, "queue"};  // ends first
};

}  // namespace race::server
