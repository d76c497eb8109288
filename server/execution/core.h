// Core: one execution on its own strand. Deliveries arrive in a queue, an Execution makes steps of them, and what comes
// of a step leaves: its entry to the journal, its calls to the host, its changes to those who watch, as frozen values.
// It never waits for a watcher.
//
// Threads: all public functions on any but the core's strand; those that say "waits" wait for it, a few seconds at
// most, and answer `unavailable` if it has not come round by then.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/execution/execution.h"
#include "core/execution/replay.h"
#include "core/value/expected.h"
#include "server/threads/strand.h"
#include "services/host/host.h"
#include "services/mutex.h"

namespace race::server {

/// Gets what cores report. Called on a core's strand, core_removed() on any thread; must be quick. All values are
/// frozen.
class CoreWatcher {
 public:
  virtual ~CoreWatcher() = default;
  /// schemas/core.json
  virtual void core_changed(const std::string& id, Value core) = 0;
  virtual void core_removed(const std::string& id) = 0;
  virtual void state_snapshot(const std::string& id, Value state) = 0;
  virtual void state_changed(const std::string& id, Value delta) = 0;
  virtual void derivation_snapshot(const std::string& id, Value next) = 0;
  virtual void derived(const std::string& id, Value steps) = 0;
  virtual void printed(const std::string& id, const std::string& text) = 0;
};

class Core : public std::enable_shared_from_this<Core> {
 public:
  /// `header.arguments` and `header.native` are frozen. All outlive the core. Errors: those of Execution::create.
  static Expected<std::shared_ptr<Core>> create(std::string id, std::string document, execution::JournalHeader header,
                                                Pool& pool, services::Host& host, CoreWatcher& watcher);

  /// Tells the watcher that there is this core: once it can be found, as whoever hears of it may ask for it at once.
  void announce();

  const std::string& id() const { return id_; }
  const semantics::Program& program() const { return *header_.program; }
  const execution::JournalHeader& header() const { return header_; }
  /// As published last (schemas/core.json).
  Value info() const EXCLUDES(mutex_);

  /// A service said something that may concern this core.
  void deliver(const services::Delivery& delivery) EXCLUDES(mutex_);

  // Commands: wait, and give the core as it is then. Error `conflict`: it is not in the state for it.
  Expected<Value> start();
  Expected<Value> pause();
  Expected<Value> resume();
  /// Ends the run between macro steps.
  Expected<Value> stop();
  /// A paused core goes as far as `goal`. One that waits for an input to get there counts as paused, and may be told
  /// another goal. Error: as execution::find_goal.
  Expected<Value> step(execution::GoalName goal);
  /// The core is paused wherever it reaches one of `goals`; they replace those of before. Errors: `too_large`, and that
  /// of execution::find_goal, at `breakpoints/N`.
  static constexpr std::size_t kMostBreakpoints = 100;  // every delta has them
  Expected<Value> set_breakpoints(std::vector<execution::GoalName> goals);

  // Questions: wait.
  /// schemas/core_state.json
  Expected<Value> state();
  /// schemas/why.json; `not_found`: no such port.
  Expected<Value> why(const std::string& port);
  /// The same as things were before micro step `micro` (from 0) of macro step `step` (from 1), recomputed on a strand
  /// of its own. `out_of_range`: no such macro step.
  Expected<Value> why_before(const std::string& port, std::size_t step, int micro);
  /// A copy, and the micro steps done if the last macro step is not complete, else -1.
  struct JournalView {
    execution::Journal journal;
    int micro = -1;
    semantics::Status status = semantics::Status::running;
    std::string outcome;
    std::optional<semantics::RunFault> fault;
  };
  Expected<JournalView> journal();
  /// schemas/derivations.json, recomputed on a strand of its own. `out_of_range`: no such macro steps; 0 = the last
  /// one.
  Expected<Value> derivations(std::size_t from, std::size_t to);

  /// No more steps are begun: the server ends.
  void close() { closed_ = true; }

  // Watching. A snapshot is published first; from then on, what changes.
  void watch_state();
  void watch_derivation(bool on);

 private:
  Core(std::string id, std::string document, execution::JournalHeader header, execution::Execution execution,
       Pool& pool, services::Host& host, CoreWatcher& watcher);
  template <typename F>
  auto on_strand(F function) -> std::invoke_result_t<F>;
  template <typename F>
  Expected<Value> replayed(const execution::Journal& journal, F function);

  // All below: on the strand.
  const semantics::Run& run() const { return execution_.run(); }
  bool is_over() const { return execution_.is_over(); }
  bool has_input() const { return run().position() == 0 || execution_.has_input(); }
  /// It is led by a goal, and no macro step can begin.
  bool awaits_input() const { return execution_.has_goal() && !execution_.is_open() && !has_input(); }
  void schedule();
  void advance();
  void take_inbox();
  std::uint32_t do_part(std::uint32_t limit);
  const execution::Progress& next_part(std::uint32_t limit);
  void emit(const execution::Progress& progress);
  void hold();
  void publish(const execution::Progress& progress);
  void publish_info();
  Value info_json() const;

  static constexpr std::uint32_t kTurn = 256;  // micro steps in one turn of the strand

  const std::string id_, document_;
  const execution::JournalHeader header_;
  Strand strand_, replay_strand_;
  services::Host& host_;
  CoreWatcher& watcher_;

  mutable services::Mutex mutex_;
  std::vector<services::Delivery> inbox_ GUARDED_BY(mutex_);
  Value info_ GUARDED_BY(mutex_);
  std::atomic<bool> derivation_watched_{false}, closed_{false};

  execution::Execution execution_;
  std::vector<execution::JournalEntry> journal_;
  Value breakpoints_ = List();  // as in schemas/core.json
  bool started_ = false, paused_ = false, scheduled_ = false, state_watched_ = false;
  Value announced_ = Value::unknown();  // what the list of cores was told last
};

}  // namespace race::server
