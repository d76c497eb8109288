// Execution: the one driver of a run. It owns the run and its waiting inputs, and turns an input into one value: the
// entry of the journal, the calls, what was printed, the change of the state, and the derivation if somebody asks.
// Hosted cores, `race run`, `race derive` and replays drive their runs with it; nothing else begins a macro step.
//
// A pure value that belongs to one thread at a time: a copy goes on from the same point, on the same thread.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/execution/executed_model.h"
#include "core/execution/goal.h"
#include "core/execution/journal.h"
#include "core/execution/state_view.h"
#include "core/execution/waiting_inputs.h"
#include "core/semantics/run.h"

namespace race::execution {

/// What is recorded of a macro step. It is settled when the macro step begins.
struct Recording {
  bool entry = true;        // its entry of the journal
  bool derivation = false;  // the trees of its micro steps
  /// Parts of it are not told one by one: what comes of them is one progress, when the macro step is over, a goal is
  /// reached, or somebody asks (tell_part()). Then a macro step that is given up before has told nobody anything.
  bool whole = false;
};

/// What came of a macro step, or of a part of one. Calls and prints are in the order in which they were made.
struct Progress {
  std::uint64_t position = 0;                       // of the macro step in the journal, from 1
  std::optional<JournalEntry> entry = {};           // none where it is not recorded, and of a step without an input
  bool begins = false;                              // the first part of the macro step: no other one has its entry
  std::uint32_t first = 0;                          // micro steps of the macro step that were done before this part
  std::uint32_t micro = 0;                          // and with it
  std::vector<semantics::OutgoingCall> calls = {};  // of complete micro steps (R16); after a fault the safe calls, too
  std::vector<std::string> printed = {};            // without the end of the line
  Dict delta = {};                                  // while it is watched: what StateView tells
  std::optional<semantics::Derivation> derivation = {};  // of the micro steps of this part
  bool edited = false;    // the model is another one than in the part before: `delta` says nothing, watch() all
  bool complete = false;  // the macro step is over
  bool untold = false;    // parts of it are done; only `position`, `first` and `micro` say something yet
  bool reached_goal = false;
  std::vector<std::uint32_t> breakpoints = {};  // that are reached, by number in set_breakpoints()
};

class Execution {
 public:
  static constexpr std::uint32_t kNoLimit = ~0U;

  /// Of a run between macro steps.
  explicit Execution(semantics::Run run) : run_(std::move(run)) {}
  /// An execution of the run of this header, which has not begun. Error: as Run::create.
  static Expected<Execution> create(const JournalHeader& header);
  /// The same without a native model: it is edited with the models of a script (edit()); the entry of an edit, which is
  /// one of the native model, cannot be replayed.
  static Expected<Execution> create(std::shared_ptr<const semantics::Program> program, const Dict& arguments,
                                    semantics::Budgets budgets = {});

  // Inputs arrive: as WaitingInputs.
  bool post_event(std::string_view service, std::string_view event, Value data) {
    return waiting_.post_event(run_, service, event, std::move(data));
  }
  bool post_event(semantics::EventId event, Value data) { return waiting_.post_event(run_, event, std::move(data)); }
  bool post_response(std::uint64_t call, bool is_error, Value data) {
    return waiting_.post_response(run_, call, is_error, std::move(data));
  }
  void post_lost(std::optional<std::string_view> service = {}) { waiting_.post_lost(run_, service); }
  void drop_waiting() { waiting_.clear(); }
  /// Whether a macro step could begin: an input waits that counts.
  bool has_input() const { return waiting_.any(run_); }
  const WaitingInputs& waiting() const { return waiting_; }

  // Macro steps. Each of these begins one and does at most `limit` of its micro steps; fewer if a goal is
  // reached or the macro step is over; with 0 it only delivers the input. Requires that the run is running and no macro
  // step is open. What came of it is valid until the next of these.
  /// The first one, which activates the root. It takes no input: those that wait have macro steps of their own.
  const Progress& start(Recording recording, std::uint32_t limit = kNoLimit);
  /// With the first waiting input; with none if none counts (a step of a script; it has no entry).
  const Progress& step(Recording recording, std::uint32_t limit = kNoLimit);
  /// With the input of an entry, as a replay does; the inputs that wait stay. Errors: `conflict`: the run does not take
  /// it here; `unavailable`: it was stopped.
  Expected<const Progress*> replay(const JournalEntry& entry, Recording recording, std::uint32_t limit = kNoLimit);
  /// Delivers an edit (core/SEMANTICS.md section 9), whose entry is `entry`, and after which the model is `model`
  /// (executed_model.h). What waits and what `model` does not name is dropped, and so are breakpoints of what it does
  /// not have; a goal of that is reached at the end of this macro step. Or what the edit waits for: nothing is changed
  /// then. Requires that the run has begun.
  tl::expected<const Progress*, std::vector<semantics::Obstacle>> edit(EditEntry entry, ExecutedModel model,
                                                                       Recording recording,
                                                                       std::uint32_t limit = kNoLimit);
  /// Sets a value or takes a port (R24). Errors: as Run::forced; `conflict`: the run has not begun.
  Expected<const Progress*> force(const semantics::Force& force, Recording recording, std::uint32_t limit = kNoLimit);
  /// The open macro step goes on.
  const Progress& continue_step(std::uint32_t limit = kNoLimit);
  /// What came of the parts of the open macro step that are untold. Requires that some are.
  const Progress& tell_part();
  bool has_untold() const { return open_ && progress_.untold; }
  /// From now on who sets `stop`, which may be null, ends a macro step after its micro step, or within a function of
  /// it: what it has come to is no state of the run. `stop` outlives what is done.
  void stop_with(const std::atomic<bool>* stop) { run_.stop_with(stop); }
  /// Ends the run between macro steps (core/SEMANTICS.md section 10): no exit function runs, what is safe is called.
  const Progress& abort();
  /// A macro step has begun and is not over.
  bool is_open() const { return open_; }
  /// Micro steps done of the open macro step; 0 if none is open.
  std::uint32_t micro() const { return open_ ? progress_.micro : 0; }
  /// Micro steps done of the macro step that this execution has begun last, also if that is over.
  std::uint32_t micro_steps() const { return progress_.micro; }

  // Goals. A step stops after the micro step that reaches one, or before it. One of those that ask what a micro step
  // has done makes every micro step record its tree, and one that stops before it does each on a copy of the run first.
  /// How far to go; none: no further than breakpoints say. It is given up when it, or a breakpoint, is reached.
  void set_goal(std::optional<Goal> goal);
  bool has_goal() const { return goal_.has_value(); }
  /// Replaces the goals that stay.
  void set_breakpoints(const std::vector<Goal>& goals);

  /// In which order the micro steps from now on come to ports, actions and children; until then the declared one. For
  /// exploration and what-if: a run in another order is not a function of its journal. Requires that it fits the
  /// program.
  void set_order(semantics::Order order) { order_ = std::move(order); }

  /// The whole state (schemas/state.json); from now on, progress has a delta, of what changed since.
  Value watch();
  bool is_watched() const { return view_.has_value(); }

  /// What it executes. As edits have made it.
  const ExecutedModel& model() const { return model_; }
  bool is_edited() const { return is_edited_; }
  const semantics::Run& run() const { return run_; }
  /// Within a macro step, as things are when its turn comes in the next micro step (`turn`), if that comes to it; else
  /// as they stand.
  struct Explained {
    semantics::Why why;
    bool turn = false;
  };
  Explained why(const semantics::Subject& subject);
  bool is_over() const { return run_.status() != semantics::Status::running; }

 private:
  friend Expected<Execution> read_checkpoint(const JournalHeader& header, const Value& json);

  const Progress& begin(std::optional<semantics::Input>&& input, Recording recording, std::uint32_t limit);
  const Progress& begin_with(semantics::Run&& run, std::optional<JournalEntry> entry, Recording recording,
                             std::uint32_t limit);
  void carry_goals(const semantics::Run& before);
  Expected<const Progress*> replay_entry(const JournalEntry& entry, Recording recording, std::uint32_t limit);
  Expected<const Progress*> replay_edit(const EditEntry& entry, Recording recording, std::uint32_t limit);
  template <semantics::Recorder R>
  void do_micro_steps(R& recorder, std::uint32_t limit);
  bool needs_facts() const;
  void do_watched_micro_steps(semantics::TreeRecorder& trees, std::uint32_t limit);
  bool stops_before_micro_step();
  void note_micro_step();
  bool goes_on_after(const MicroStepFacts* facts);
  template <typename Asks>
  bool any_goal(Asks asks);
  void begin_part();
  const Progress& do_part(std::uint32_t limit);
  const Progress& finish();

  semantics::Run run_;
  ExecutedModel model_;
  bool is_edited_ = false;
  WaitingInputs waiting_;
  std::optional<StateView> view_;
  semantics::Order order_ = semantics::Order::declared();
  std::optional<GoalWatch> goal_;
  std::vector<GoalWatch> breakpoints_;

  bool open_ = false;
  Recording recording_;  // of the open macro step
  Progress progress_;    // the last part
};

/// Whether the step stops at one: all are asked, as each counts anew from where it was reached. The goal is given up.
template <typename Asks>
bool Execution::any_goal(Asks asks) {
  bool any = goal_ && asks(*goal_);
  for (std::uint32_t i = 0; i < breakpoints_.size(); ++i) {
    if (!asks(breakpoints_[i])) continue;
    progress_.breakpoints.push_back(i);
    any = true;
  }
  if (any) goal_.reset();
  return any;
}

}  // namespace race::execution
