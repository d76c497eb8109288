// Core: one run on its own strand. Deliveries arrive in a queue, an Execution makes steps of them, their entries go to
// the journal, and what comes of a step leaves once its entry is durable (core/SEMANTICS.md section 10): calls to the
// host, changes to those who watch as frozen values, answers to those who asked. Steps are computed meanwhile.
// It never waits for a watcher, nor for the disk: it stops when it is too far ahead.
//
// When the journal fails, or the run was under way when an earlier server ended, the run is *interrupted*: it is as the
// journal says, its open calls are answered `unavailable`, and it goes on when somebody says so.
//
// Threads: all public functions on any. What takes its turn on the strand gives its value to a Done, on the strand or
// another thread, and `unavailable` if its turn has not come after some seconds. Of each there is a function that waits
// for the value, not to be called on the strand.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/execution/execution.h"
#include "core/execution/replay.h"
#include "core/execution/why.h"
#include "core/value/expected.h"
#include "server/execution/breakpoint.h"
#include "server/execution/held_outputs.h"
#include "server/execution/live_edit.h"
#include "server/execution/timing_recorder.h"
#include "server/store/journal_writer.h"
#include "server/store/runs.h"
#include "server/threads/computing_share.h"
#include "server/threads/deadlines.h"
#include "server/threads/done.h"
#include "server/threads/stop.h"
#include "server/threads/strand.h"
#include "server/threads/watchdog.h"
#include "server/threads/worker.h"
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
  /// The model is another one: no delta leads from what was told before to this.
  virtual void state_replaced(const std::string& id, Value state) = 0;
  virtual void state_changed(const std::string& id, Value delta) = 0;
  virtual void derivation_snapshot(const std::string& id, Value next) = 0;
  virtual void derived(const std::string& id, Value steps) = 0;
  virtual void printed(const std::string& id, const std::string& text) = 0;
  /// A stored run that is damaged or becomes no core: why.
  virtual void run_lost(const std::string& id, const std::string& why) = 0;
};

/// What cores use; all of it outlives them.
struct CoreResources {
  Pool& pool;
  services::Host& host;
  CoreWatcher& watcher;
  Runs& runs;
  JournalWriter& writer;
  Worker& replays;
  Deadlines& deadlines;
  Watchdog& watchdog;
  /// A macro step may compute for so long; then the run is interrupted.
  std::chrono::milliseconds longest_step{10'000};
};

/// Who begins a run, or lets it go on.
struct Supervision {
  std::uint64_t control = 0;            // theirs, if they are at the controls (services::Beginning)
  std::optional<bool> supervised = {};  // nothing: as it was
};

class Core final : public std::enable_shared_from_this<Core>, private RunSink {
 public:
  /// Of a stored run that has not begun; `header` is its header, whose arguments and native model are frozen. Errors:
  /// those of Execution::create.
  static Expected<std::shared_ptr<Core>> create(RunRecord run, execution::JournalHeader header,
                                                const CoreResources& resources, bool live = false);
  /// Of a stored run that was under way when the server ended: interrupted, unless its journal says that it is over.
  /// Waits until it is rebuilt; what takes long goes on without. Errors: those of Execution::create and of the store;
  /// `conflict`: the journal is of another run.
  static Expected<std::shared_ptr<Core>> recover(RunRecord run, execution::JournalHeader header,
                                                 const CoreResources& resources);

  /// Tells the watcher that there is this core: once it can be found, as whoever hears of it may ask for it at once.
  void announce();

  const std::string& id() const { return id_; }
  RunId run_id() const { return run_id_; }
  /// Of the run as it began; edits may have replaced its model since.
  const execution::JournalHeader& header() const { return header_; }
  /// What it executes now; perhaps of an edit that is not durable yet.
  execution::ExecutedModel model() const EXCLUDES(mutex_);
  /// Whether its model names the event.
  bool names_event(const std::string& service, const std::string& event) const EXCLUDES(mutex_);
  /// As published last (schemas/core.json).
  Value info() const EXCLUDES(mutex_);

  /// A service said something that may concern this core. What waits is bounded: beyond that the run is interrupted, or
  /// what comes is dropped if it is already.
  void deliver(const services::Delivery& delivery) EXCLUDES(mutex_);

  /// The state of a service is this from now on; nothing: it is not available.
  void service_changed(const std::string& service, const std::optional<std::string>& state);
  /// What is known of the times of the run that is not in the store yet (TimingRecorder::blocks).
  std::vector<TimingBlock> timing() const { return timing_.blocks(); }

  static constexpr std::size_t kMostInputs = 10'000;         // that wait
  static constexpr std::size_t kMostInputUnits = 4U << 20U;  // of their data (Value::size_units), but for the last
  static constexpr std::size_t kMostKeptUnits = 16U << 20U;  // of what a run keeps of them, but for the last

  // Commands: give the core as it is then, once what they caused is durable. Errors: `conflict`: it is not in the state
  // for it; `storage`: the disk fails, and the run is interrupted; `unavailable`: it has not begun the command in time,
  // and never will.
  // Errors also of start(), resume() and step(): those of services::MotionGate::begin.
  void start(Done<Value> done, Supervision by = {});
  void pause(Done<Value> done);
  /// Of an interrupted run: it goes on from its last macro step.
  void resume(Done<Value> done, Supervision by = {});
  /// Nothing more begins in it until a person lets it go on: it is paused before it takes what comes from now on. Any
  /// thread; waits for nothing.
  void hold_at_once();
  /// Ends the run between macro steps.
  void stop(Done<Value> done);
  /// Ends the run for good, or keeps one that has not begun from beginning: whether it has begun. Errors: as stop().
  void dismiss(Done<bool> done);
  /// What a person has said about a run that has not begun.
  struct Preparation {
    bool paused = false;
    std::vector<Breakpoint> breakpoints;
  };
  /// No command begins this run any more: another model is loaded in its place. `conflict`: it has begun.
  void retire(Done<Preparation> done);
  /// It was not: the run may begin.
  void reinstate();
  /// A paused core goes as far as `goal`. One that waits for an input to get there counts as paused, and may be told
  /// another goal. Error: as execution::find_goal.
  void step(execution::GoalName goal, Done<Value> done, Supervision by = {});
  /// The core is paused wherever it reaches one of `goals`; they replace those that `author` has set before, or those
  /// of all if nobody says who sets them. After an edit an id is that of the same element, also under another name, a
  /// path is of what is there then, and what names nothing is dropped. Errors: `too_large`: more than that many, with
  /// those of others; that of execution::find_goal, at `breakpoints/N/FIELD`.
  static constexpr std::size_t kMostBreakpoints = 100;  // every delta has them
  void set_breakpoints(std::vector<execution::GoalName> goals, std::string author, Done<Value> done);

  /// Sets a value or takes a port of a run that has begun, in a macro step of its own; a paused one stays paused.
  /// `control`: of who does, as in Supervision. `conflict`: it is not running, or paused in a macro step; those of
  /// semantics::Run::forced and services::MotionGate::may_force.
  void force(semantics::Force force, Done<Value> done, std::uint64_t control = 0);

  // Edits: a live core follows the revisions of its document without violations, between macro steps, or as soon as it
  // can. Not to be started by default: a new port or action may move the robot.
  bool is_live() const { return live_; }
  /// `conflict`: it is over; `storage`: it is interrupted, and cannot be read yet.
  void set_live(bool live, Done<Value> done);
  /// The edit that waits, to this revision, may reach the run (services::MotionGate::confirms_edits). `conflict`: no
  /// edit to this revision waits.
  void confirm_edit(std::int64_t revision, Done<Value> done);
  /// Gets to another revision; in place of what waits. Does not wait.
  void follow(LiveEdit edit);
  /// It cannot get to this revision, and stays as it is. Does not wait.
  void refuse_edit(std::int64_t revision, const std::vector<Error>& errors);

  // Questions. They are answered with what is durable.
  /// schemas/core_state.json
  void state(Done<Value> done);
  /// schemas/native.json of what it executes.
  void native(Done<Value> done);
  /// schemas/why.json. Errors: those of execution::find_subject.
  void why(execution::WhyQuestion question, Done<Value> done);

  // Questions about the past: not to the strand, so a core that is busy answers them, too. They are about what was told
  // last. Error `storage`: the run cannot be read.
  /// How many entries its journal has.
  Expected<std::uint64_t> position() const EXCLUDES(mutex_);
  /// why() as things were in micro step `micro` (from 0) of macro step `step` (from 1), recomputed on the thread of
  /// replays until nobody waits any more. `out_of_range`: no such macro step; `unavailable`: it takes long, and goes on
  /// from where it was when it is asked again.
  void why_before(execution::WhyQuestion question, std::size_t step, int micro, SharedStop gone, Done<Value> done);
  /// schemas/derivations.json, recomputed likewise. `out_of_range`: no such macro steps; 0 = the last one.
  void derivations(std::size_t from, std::size_t to, SharedStop gone, Done<Value> done);

  /// schemas/past.json of the moment after micro step `micro` (0: before the first) of macro step `step`, or of its end
  /// if it has fewer, recomputed likewise. `out_of_range`: no such macro step.
  void past(std::uint64_t step, int micro, SharedStop gone, Done<Value> done);

  // The same for who waits.
  Expected<Value> start() {
    return wait_for<Value>([&](Done<Value> done) { start(std::move(done)); });
  }
  Expected<Value> pause() {
    return wait_for<Value>([&](Done<Value> done) { pause(std::move(done)); });
  }
  Expected<Value> resume() {
    return wait_for<Value>([&](Done<Value> done) { resume(std::move(done)); });
  }
  Expected<Value> stop() {
    return wait_for<Value>([&](Done<Value> done) { stop(std::move(done)); });
  }
  Expected<Preparation> retire() {
    return wait_for<Preparation>([&](Done<Preparation> done) { retire(std::move(done)); });
  }
  Expected<Value> step(execution::GoalName goal) {
    return wait_for<Value>([&](Done<Value> done) { step(std::move(goal), std::move(done)); });
  }
  Expected<Value> set_breakpoints(std::vector<execution::GoalName> goals, std::string author = {}) {
    return wait_for<Value>(
        [&](Done<Value> done) { set_breakpoints(std::move(goals), std::move(author), std::move(done)); });
  }
  Expected<Value> force(semantics::Force force) {
    return wait_for<Value>([&](Done<Value> done) { this->force(std::move(force), std::move(done)); });
  }
  Expected<Value> set_live(bool live) {
    return wait_for<Value>([&](Done<Value> done) { set_live(live, std::move(done)); });
  }
  Expected<Value> state() {
    return wait_for<Value>([&](Done<Value> done) { state(std::move(done)); });
  }
  Expected<Value> native() {
    return wait_for<Value>([&](Done<Value> done) { native(std::move(done)); });
  }
  Expected<Value> derivations(std::size_t from, std::size_t to) {
    return wait_for<Value>(
        [&](Done<Value> done) { derivations(from, to, std::make_shared<Stop>(false), std::move(done)); });
  }

  /// No more steps are begun: it is removed.
  void close() { closed_ = true; }
  /// Nor is anything read back: the server ends.
  void end() {
    close();
    server_ends_ = true;
    *end_rebuild_ = *end_last_step_ = true;
  }

  // Watching. A snapshot is published first; from then on, what changes.
  void watch_state();
  void watch_derivation(bool on);
  /// This core, which nobody knows yet, comes in the place of `other`, a retired one: it is watched as that was, and
  /// prepared so; breakpoints that the new model does not have are dropped.
  void replace(const Core& other, Preparation preparation);

 private:
  Core(RunRecord run, execution::JournalHeader header, execution::Execution execution, Watchdog::Flag give_up,
       const CoreResources& resources, bool live);

  // RunSink.
  void durable(std::uint64_t ticket) override;
  void stalled(const Error& error) override;
  void failed(const Error& error) override;

  /// Where a run is: `micro` steps of the macro step `step`, -1 if it is complete.
  struct Reached {
    std::uint64_t step;
    int micro;
    Value status;  // status, outcome, fault as of core.json; frozen
  };
  template <typename T, typename F>
  void on_strand(Done<T> done, F function);
  template <typename T, typename F>
  void when_rebuilt(Done<T> done, F function);
  template <typename F>
  void replayed(SharedStop gone, Done<Value> done, F function);
  Expected<Reached> reached() const EXCLUDES(mutex_);
  Expected<int> told_micro(std::uint64_t step, int micro) const;
  void set_reached(Expected<Reached> reached) EXCLUDES(mutex_);
  Reached reached_now() const;

  // All below: on the strand.
  const semantics::Run& run() const { return execution_.run(); }
  const semantics::Program& program() const { return run().program(); }
  bool is_over() const { return execution_.is_over(); }
  bool has_input() const { return run().position() == 0 || execution_.has_input(); }
  /// It is led by a goal, and no macro step can begin.
  bool awaits_input() const { return execution_.has_goal() && !execution_.is_open() && !has_input(); }
  void schedule();
  void advance();
  bool take_inbox();
  bool has_room();
  bool keeps_within_bounds();
  std::uint32_t do_part(std::uint32_t limit);
  const execution::Progress& next_part(std::uint32_t limit);
  void take(const execution::Progress& progress);
  void tell_untold();
  bool finish_macro_step();
  bool gave_up();
  void give_up_macro_step(const char* reason, std::string why);
  execution::Recording recording() const { return {.derivation = derivation_watched_, .whole = true}; }
  void hold();
  Expected<void> ready_to_go_on();
  Expected<void> take_fence(const Supervision& by);
  Expected<void> end_run_now();
  void end_when_rebuilt(Done<Value> done);

  // core_output.cpp: what leaves.
  void emit(const execution::Progress& progress);
  std::pair<std::size_t, std::size_t> hold_many(const execution::Progress& progress);
  void say_due();
  void go_on_saying();
  void record(const execution::Progress& progress);
  RunEnd run_end() const;
  Value delta_of(const execution::Progress& progress) const;
  Value steps_of(const execution::Progress& progress) const;
  void note_times(const execution::Progress& progress);
  void write_times_later();
  void write_times();
  void note_services();
  void publish_info();
  void publish_snapshot(void (CoreWatcher::*publish)(const std::string&, Value));
  void publish_next_derivation();
  /// What info() gives from now on.
  void keep_info(Value info) EXCLUDES(mutex_);
  void set_info(Value info) EXCLUDES(mutex_);
  Value info_json() const;

  // core_edits.cpp
  void take_edit(LiveEdit edit);
  void follow_again();
  bool deliver_edit(std::uint32_t limit);
  void abandon_unless_open(const std::vector<std::uint64_t>& calls);
  void look_ahead();
  void note_obstacles(const std::vector<semantics::Obstacle>& obstacles);
  void find_breakpoints();
  void set_model(execution::ExecutedModel model) EXCLUDES(mutex_);
  Dict edit_info() const;

  // core_recovery.cpp: interruptions.
  struct Rebuilt {
    RunRecord record;
    execution::Execution execution;
    std::vector<semantics::OutgoingCall> safe_calls;  // of one aborted in its last macro step: a restart makes none
  };
  void make_safe_calls(const std::vector<semantics::OutgoingCall>& calls) const;
  void interrupt(const Error& error, const char* reason = "storage");
  /// What throws may leave a step half done: the run is what its journal says.
  void interrupt_after(const std::exception& failure);
  /// What it has handed over to the journal is stored; then the run is what that says.
  void interrupt_and_rebuild(const Error& error, const char* reason);
  /// Posts work that may throw, in the turn that the core has now.
  void post_turn(Work work);
  /// It computes much: its work waits with the rest of turns.
  bool is_busy() const { return computing_.is_over(std::chrono::steady_clock::now()); }
  void do_turn_before();
  Work measured(Work work);
  Work interrupting(Work work);
  void publish_interruption();
  void end_rebuilt_run();
  Expected<void> readable() const;
  /// It is interrupted, and not as its journal says yet.
  bool is_to_rebuild() const { return interruption_ && !interruption_->stalled && !interruption_->rebuilt; }
  void rebuild_later();
  void take_rebuilt(std::uint64_t interruption, Expected<Rebuilt> rebuilt);
  void take(Rebuilt rebuilt);
  void open_journal();
  // On any other thread: it waits for the disk.
  Expected<Rebuilt> rebuild(std::chrono::milliseconds longest) const;
  Expected<Rebuilt> rebuild_last_step(execution::Replay& replay, RunRecord stored, execution::Execution before,
                                      std::chrono::milliseconds longest) const;
  Rebuilt rebuilt_from(RunRecord stored, execution::Execution rebuilt) const;
  static Error as_timed_out(Error error);
  // On any: what could not be read back before is, if the disk works now. Errors: `storage`, `corrupt`.
  void ensure_rebuilt(Done<void> done);
  void rebuild_for(std::uint64_t interruption, Done<void> done);

  static constexpr std::uint32_t kTurn = 256;  // micro steps in one turn of the strand,
  static constexpr std::uint32_t kPart = 16;   // after so many at most the time is looked at
  // Of the processor, as the next.
  static constexpr std::chrono::milliseconds kTurnTime{2};
  /// So long it says what is durable, then the others have their turn.
  static constexpr std::chrono::microseconds kSayTime{300};
  static constexpr std::size_t kPiece = 32;  // prints, or calls, that are said at once
  /// A person who pauses or stops a core waits so long for the end of its macro step.
  static constexpr std::chrono::milliseconds kWaitForStep{200};
  static constexpr std::chrono::milliseconds kLongestRebuild{20'000};
  static constexpr std::chrono::milliseconds kRebuildAtStart{1'000};  // the server does not begin before
  static constexpr std::uint32_t kMostUntold = 256;                   // micro steps with their derivation
  static constexpr std::chrono::seconds kReplayTimeout{5};

  const std::string id_;
  const RunId run_id_;
  const execution::JournalHeader header_;
  const CoreResources resources_;
  Strand strand_;

  mutable services::Mutex mutex_;
  struct Inbox {
    std::vector<services::Delivery> deliveries;
    std::vector<TimingRecorder::Clock::time_point> times;  // when they came
    std::size_t units = 0;                                 // of their data
    bool has_dropped = false;                              // what came beyond the bounds
    bool woken = false;                                    // its core will look
  };
  Inbox inbox_ GUARDED_BY(mutex_);
  Value info_ GUARDED_BY(mutex_);
  execution::ExecutedModel model_ GUARDED_BY(mutex_);
  Expected<Reached> reached_ GUARDED_BY(mutex_);  // as told last
  std::atomic<bool> state_watched_{false}, derivation_watched_{false}, closed_{false}, live_{false},
      server_ends_{false};
  ComputingShare computing_;
  std::atomic<bool> ends_later_{false};                             // who stops it does not wait until it is read back
  std::atomic<bool> is_stopped_{false};                             // and it ends then
  std::atomic<bool> state_asked_{false}, derivation_asked_{false};  // and what is asked for has not come

  RunRecord record_;  // as it was stored when the core was made, or rebuilt; its number and document stay
  std::shared_ptr<RunJournal> journal_;
  HeldOutputs held_;
  TimingRecorder timing_;
  std::atomic<bool> times_due_{false};  // what is noted will be written
  bool saying_ = false;                 // work is posted that says more of what is durable
  std::size_t waiting_units_ = 0;       // of the inputs that wait in the execution, or more
  std::size_t received_units_ = 0;      // that the run keeps of inputs, or more
  const Watchdog::Flag give_up_;        // what is computed takes too long: the execution stops, in a fault of nobody's
  const Watchdog::Flag end_rebuild_ = std::make_shared<std::atomic<bool>>(false);    // the same, of what is read back
  const Watchdog::Flag end_last_step_ = std::make_shared<std::atomic<bool>>(false);  // and of the last step of that
  std::uint32_t part_ = 1;                 // micro steps until the time is looked at: few while they are slow
  std::chrono::nanoseconds step_time_{0};  // that the open macro step has computed
  execution::Execution execution_;
  std::vector<Breakpoint> breakpoints_;
  List reached_breakpoints_;             // at which it is paused, by number
  std::atomic<bool> hold_asked_{false};  // by hold_at_once()
  bool supervised_ = false;              // as whoever let it go on last wanted it
  std::uint64_t fence_ = 0;  // of its calls (services::MotionGate); 0: no person has begun it since the server did
  bool started_ = false, paused_ = false, scheduled_ = false;
  Value announced_ = Value::unknown();  // what the list of cores was told last

  std::int64_t revision_;          // of its document, which it executes
  std::uint64_t model_since_ = 0;  // schemas/core.json, `model`
  struct WaitingEdit {
    LiveEdit edit;
    List waits;                                   // schemas/core.json
    std::optional<semantics::StateId> state;      // which has to be left before it can be delivered
    bool confirmed = false, unconfirmed = false;  // by who has the controls; it waits for that
  };
  std::optional<WaitingEdit> edit_;
  Value refused_edit_ = Value::unknown();  // schemas/core.json
  std::function<void()> follow_again_;     // LiveEdit::stale, once an edit has come

  // Interrupted: since when it is as the journal says, until somebody lets it go on.
  struct Interruption {
    std::uint64_t number;     // what is read back for an earlier one comes too late
    std::string_view reason;  // schemas/core.json
    std::string message;
    bool was_paused = false;  // before it
    bool stalled = false;     // the disk has not answered: what the journal says is not known yet
    bool rebuilt = false;     // the execution is as the journal says
    bool rebuilding = false;  // it will be, or it will be said why not
  };
  static constexpr const char *kOverload = "overload", *kDeadline = "deadline";
  std::optional<Interruption> interruption_;
  std::uint64_t interruptions_ = 0;

  const std::shared_ptr<execution::Replay> replay_;  // of the thread of replays
};

}  // namespace race::server
