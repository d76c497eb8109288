// Cores: all cores of the server, by id, which is the number of the run; brings them what services say.
//
// Threads: any. What a core has to take part in gives its result to a Done and goes on on a thread of its own; of each
// there is a function that waits for it.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "server/execution/core.h"
#include "server/store/documents.h"
#include "services/mutex.h"

namespace race::server {

class Cores {
 public:
  static constexpr std::size_t kMost = 128;

  /// All outlive this.
  Cores(Pool& pool, services::Host& host, CoreWatcher& watcher, Runs& runs, JournalWriter& writer, Worker& replays,
        Deadlines& deadlines)
      : resources_{pool, host, watcher, runs, writer, replays, deadlines, watchdog_} {}

  /// A core of a document in a revision that waits to be started; its run is stored. Does not wait for any core.
  /// `live`: it follows its document. Errors: violations of the program (with `type` for a service of another type than
  /// the document expects), an argument that does not fit, `conflict`: there are kMost cores already, and no run of
  /// them is over; `storage`. In place of a refusal the oldest core whose run is over is removed: its run stays in the
  /// store.
  Checked<std::shared_ptr<Core>> create(const StoredDocument& stored, Dict arguments, bool live = false);
  /// Whether create() would make a core of this, but for the number of cores. Errors: as create().
  Checked<void> check(const StoredDocument& stored, Dict arguments) const;
  /// Another model, or the same with other arguments, in a core that has not begun. Nothing in `live`: it follows its
  /// document if it did before. Errors: as create(); `conflict`: it has, or it is being loaded or removed; `not_found`.
  void load(const std::string& id, const StoredDocument& stored, Dict arguments, std::optional<bool> live,
            Done<std::shared_ptr<Core>, std::vector<Error>> done) EXCLUDES(mutex_);
  Checked<std::shared_ptr<Core>> load(const std::string& id, const StoredDocument& stored, Dict arguments);
  /// The edit that brings a core that has begun to a revision of its document. Errors: as create(), and those of
  /// execution::edit_between.
  Checked<LiveEdit> edit_for(const Core& core, const StoredDocument& stored) const;
  /// Every stored run that is not over becomes a core again; those that had begun are interrupted. To be called
  /// before any core is created, and when the store has become another one. Those that cannot be rebuilt stay in the
  /// store; the watcher is told why. Errors: those of Runs, of the file as a whole.
  Expected<void> recover();
  /// `not_found`: there is none of this id.
  Expected<std::shared_ptr<Core>> find(const std::string& id) const;
  /// In order of creation.
  std::vector<std::shared_ptr<Core>> all() const;
  /// Ends a core's run, removes the core and reports the removal. A run that never began is removed from the store,
  /// too. Errors, after which the core is there: `not_found`, `conflict` (it is being loaded or removed), `unavailable`
  /// (it is busy), `storage` (its end cannot be stored).
  void remove(const std::string& id, Done<std::shared_ptr<Core>> done) EXCLUDES(mutex_);
  Expected<std::shared_ptr<Core>> remove(const std::string& id);

  /// From now on no run begins and no core is created, until reopen(); the store may become another. Waits for the
  /// cores. `conflict`: a run is not over, or a core is being created, loaded or removed.
  Expected<void> close_for_restore() EXCLUDES(mutex_);
  void reopen() EXCLUDES(mutex_);

  /// An event goes to every core that names it, a response to the core whose call it answers.
  void deliver(const services::Delivery& delivery);
  /// The state of a service is this from now on; nothing: it is not available.
  void service_changed(const std::string& service, const std::optional<std::string>& state);
  /// No core goes on, and no run becomes one: the server ends.
  void close();
  /// Finishes loads and removals that are under way.
  void end_changes() { changes_.end(); }

 private:
  /// 0 of what is no id.
  static RunId number_of(const std::string& id);
  /// What a run begins with. Its program was checked against these RSMs, which are those of one moment: a process may
  /// bring others at any time.
  struct RunModel {
    execution::JournalHeader header;
    execution::Interfaces services;
  };
  Checked<RunModel> run_model(const StoredDocument& stored, Dict arguments) const;
  /// For a core that is being created. The core that has made way for it, if one had to.
  Expected<std::shared_ptr<Core>> reserve_place() EXCLUDES(mutex_);
  /// Of those whose runs are over, the first that was created; it is a core no more. Nothing: there is none.
  std::shared_ptr<Core> take_oldest_over() REQUIRES(mutex_);
  Expected<std::shared_ptr<Core>> create_run(const StoredDocument& stored, RunModel model, bool live);
  void add(const std::shared_ptr<Core>& core) EXCLUDES(mutex_);

  // A core that is loaded or removed: one at a time does that.
  struct Changing {
    services::Mutex mutex;
    std::set<RunId> ids GUARDED_BY(mutex);
  };
  class Change;
  struct Load;
  Expected<std::shared_ptr<Change>> begin_change(RunId id, bool is_load) EXCLUDES(mutex_);
  Checked<std::shared_ptr<Core>> finish_load(Load& load, Core::Preparation preparation) EXCLUDES(mutex_);
  Expected<std::shared_ptr<Core>> finish_removal(const std::shared_ptr<Core>& core, const Expected<bool>& had_begun)
      EXCLUDES(mutex_);

  Watchdog watchdog_;
  const CoreResources resources_;
  const std::shared_ptr<Changing> changing_ = std::make_shared<Changing>();  // held by changes
  mutable services::Mutex mutex_;
  std::map<RunId, std::shared_ptr<Core>> cores_ GUARDED_BY(mutex_);
  std::size_t coming_ GUARDED_BY(mutex_) = 0;  // being created
  bool restoring_ GUARDED_BY(mutex_) = false;
  std::atomic<bool> ends_{false};
  Pool changes_{1};  // where loads and removals go on
};

/// Whether the run of a core (schemas/core.json) is over.
bool is_over(const Value& core);

/// schemas/cores.json, frozen.
Value cores_json(const Cores& cores);

/// schemas/native.json of a document, frozen.
Checked<Value> native_json(const rcm::Document& document);

}  // namespace race::server
