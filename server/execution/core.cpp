#include "server/execution/core.h"

#include <algorithm>
#include <ctime>

#include "server/execution/core_internal.h"

namespace race::server {

using execution::Execution;
using execution::Goal;
using execution::Progress;

namespace {

using Clock = std::chrono::steady_clock;

tl::unexpected<Error> conflict(std::string why) { return unexpected(ErrorCode::conflict, std::move(why)); }

/// That this thread has computed.
std::chrono::nanoseconds thread_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Of the program, or what is wrong with one of them.
Expected<std::vector<Goal>> find_goals(const semantics::Program& program,
                                       const std::vector<execution::GoalName>& names) {
  std::vector<Goal> goals;
  for (const execution::GoalName& name : names) {
    const auto goal = find_goal(program, name);
    if (!goal)
      return unexpected(goal.error().code, goal.error().message, "breakpoints/" + std::to_string(goals.size()));
    goals.push_back(*goal);
  }
  return goals;
}

}  // namespace

Expected<std::shared_ptr<Core>> Core::create(RunRecord run, execution::JournalHeader header,
                                             const CoreResources& resources, bool live) {
  const auto give_up = std::make_shared<std::atomic<bool>>(false);
  execution::JournalHeader stoppable = header;
  stoppable.budgets.evaluation.stop = give_up.get();
  ASSIGN_OR_RETURN(Execution execution, Execution::create(stoppable));
  // Held by the registry, and by work on its way through the strand.
  std::shared_ptr<Core> core(
      new Core(std::move(run), std::move(header), std::move(execution), give_up, resources, live));
  core->open_journal();
  return core;
}

Core::Core(RunRecord run, execution::JournalHeader header, Execution execution, Watchdog::Flag give_up,
           const CoreResources& resources, bool live)
    : id_(std::to_string(run.id)),
      run_id_(run.id),
      header_(std::move(header)),
      resources_(resources),
      strand_(resources.pool),
      model_(execution.model()),
      live_(live),
      record_(std::move(run)),
      give_up_(std::move(give_up)),
      execution_(std::move(execution)),
      replay_(std::make_shared<execution::Replay>(header_, resources.runs.source(run_id_))) {
  revision_ = record_.revision;
  info_ = info_json();
  reached_ = reached_now();
}

void Core::announce() {
  strand_.post([self = shared_from_this()] { self->publish_info(); });
}

Value Core::info() const {
  const services::MutexLock lock(mutex_);
  return info_;
}

void Core::deliver(const services::Delivery& delivery) {
  {
    const services::MutexLock lock(mutex_);
    if (inbox_.deliveries.size() >= kMostInputs || inbox_.units > kMostInputUnits) {
      inbox_.has_dropped = true;
      return;
    }
    inbox_.units += delivery.units;
    inbox_.deliveries.push_back(delivery);
    if (inbox_.deliveries.size() > 1) return;  // who put the first one has woken it
  }
  post_turn([this] { advance(); });
}

// The first macro step begins at once, so that the answer says that it has.
void Core::start(Done<Value> done) {
  when_rebuilt<Value>(std::move(done), [this]() -> Expected<Value> {
    if (started_) return conflict("core " + id_ + " was started before");
    if (closed_) return conflict("core " + id_ + " has another model now");
    started_ = true;
    advance();
    publish_info();
    return info_json();
  });
}

void Core::retire(Done<Preparation> done) {
  on_strand<Preparation>(std::move(done), [this]() -> Expected<Preparation> {
    if (started_) return conflict("core " + id_ + " was started before");
    if (closed_) return conflict("core " + id_ + " is going away");
    closed_ = true;
    return Preparation{paused_, breakpoint_names_};
  });
}

// Not on the strand: nobody knows this core yet. What is shown of it has all of this from the first moment.
void Core::replace(const Core& other, Preparation preparation) {
  breakpoint_names_ = std::move(preparation.breakpoints);
  find_breakpoints();
  paused_ = preparation.paused;
  {
    const services::MutexLock lock(mutex_);
    info_ = info_json();
  }
  if (other.state_watched_) watch_state();
  if (other.derivation_watched_) watch_derivation(true);
}

void Core::pause(Done<Value> done) {
  on_strand<Value>(std::move(done), [this]() -> Expected<Value> {
    do_turn_before();
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    if (is_over()) return conflict("core " + id_ + " is over");
    if (!execution_.has_goal() && !paused_) finish_macro_step();
    if (!paused_) hold();
    return info_json();
  });
}

void Core::resume(Done<Value> done) {
  when_rebuilt<Value>(std::move(done), [this]() -> Expected<Value> {
    if (started_ || interruption_)
      if (auto ready = ready_to_go_on(); !ready) return tl::unexpected(std::move(ready).error());
    paused_ = false;
    execution_.set_goal(std::nullopt);
    schedule();
    publish_info();
    return info_json();
  });
}

// A run that had too much to do may be interrupted before its end is stored: it ends when it is read back, and nobody
// waits for that.
void Core::stop(Done<Value> done) {
  Done<Value> stopped = [self = shared_from_this(), done](const Expected<Value>& answer) {
    if (answer || !self->is_overloaded_) return done(answer);
    self->end_when_rebuilt(done);
  };
  if (is_overloaded_) return end_when_rebuilt(std::move(done));
  when_rebuilt<Value>(std::move(stopped), [this]() -> Expected<Value> {
    if (!started_) return conflict("core " + id_ + " was not started");
    if (auto ended = end_run_now(); !ended) return tl::unexpected(std::move(ended).error());
    return info_json();
  });
}

void Core::end_when_rebuilt(Done<Value> done) {
  on_strand<Value>(std::move(done), [this]() -> Expected<Value> {
    if (is_overloaded_)
      interruption_->ends = true;
    else if (auto ended = end_run_now(); !ended)
      return tl::unexpected(std::move(ended).error());
    return info_json();
  });
}

void Core::dismiss(Done<bool> done) {
  when_rebuilt<bool>(std::move(done), [this]() -> Expected<bool> {
    closed_ = closed_ || !started_;
    if (!started_ || (is_over() && !interruption_)) return started_;
    if (auto ended = end_run_now(); !ended && ended.error().code != ErrorCode::conflict)
      return tl::unexpected(std::move(ended).error());
    return true;
  });
}

Expected<void> Core::end_run_now() {
  if (auto ready = ready_to_go_on(); !ready) return ready;
  execution_.set_goal(std::nullopt);
  execution_.set_breakpoints({});
  paused_ = false;  // it may have stopped within the macro step
  if (!finish_macro_step()) give_up_macro_step("stopped", "it was stopped in a long macro step");
  if (interruption_) {
    interruption_->ends = true;
    return {};
  }
  if (!is_over()) emit(execution_.abort());
  return {};
}

void Core::step(execution::GoalName name, Done<Value> done) {
  when_rebuilt<Value>(std::move(done), [this, name = std::move(name)]() -> Expected<Value> {
    do_turn_before();
    if (is_over() && !interruption_) return conflict("core " + id_ + " is over");
    if (!started_ || !(paused_ || awaits_input())) return conflict("core " + id_ + " is not paused");
    ASSIGN_OR_RETURN(const Goal goal, find_goal(program(), name));
    if (auto ready = ready_to_go_on(); !ready) return tl::unexpected(std::move(ready).error());
    execution_.set_goal(goal);
    paused_ = false;
    advance();
    publish_info();
    return info_json();
  });
}

void Core::set_breakpoints(std::vector<execution::GoalName> names, Done<Value> done) {
  on_strand<Value>(std::move(done), [this, names = std::move(names)]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    if (is_over()) return conflict("core " + id_ + " is over");
    if (names.size() > kMostBreakpoints)
      return unexpected(ErrorCode::too_large, "there may be " + std::to_string(kMostBreakpoints) + " breakpoints",
                        "breakpoints");
    ASSIGN_OR_RETURN(const std::vector<Goal> goals, find_goals(program(), names));
    execution_.set_breakpoints(goals);
    breakpoint_names_ = names;
    publish_info();
    return info_json();
  });
}

void Core::schedule() {
  if (std::exchange(scheduled_, true)) return;
  strand_.post_later(measured([this] {
    scheduled_ = false;
    advance();
  }));
}

// The turn that waits, before who pauses or steps: what had come before is done.
void Core::do_turn_before() {
  if (started_ && !paused_ && !interruption_) advance();
}

// With the rest of turns if it is busy: so those that have little to do wait for no function that takes long.
void Core::post_turn(Work work) {
  Work turn = measured(std::move(work));
  if (Clock::now() < busy_until_.load()) return strand_.post_later(std::move(turn));
  strand_.post(std::move(turn));
}

// Work that may throw. What counts is the time of the processor: a machine under load makes no core a busy one.
Work Core::measured(Work work) {
  return interrupting([this, work = std::move(work)] {
    const auto begin = thread_time();
    work();
    if (thread_time() - begin > kLongWork) busy_until_ = Clock::now() + kBusyTime;
  });
}

// One turn: as many micro steps as are its due, then the others on this pool. Too far ahead of the disk, it is left
// until that has caught up (durable()).
void Core::advance() {
  if (!take_inbox()) return;
  if (!started_ || paused_ || closed_ || is_over()) return;
  const auto end = Clock::now() + kTurnTime;
  for (std::uint32_t left = kTurn; left > 0 && Clock::now() < end;) {
    if (held_.is_full()) return;
    if (!execution_.is_open() && !take_inbox()) return;
    if (!execution_.is_open() && deliver_edit(std::min(left, kPart))) {
      if (paused_ || is_over()) return;
      continue;
    }
    if (!execution_.is_open() && !has_input()) return publish_info();
    left -= do_part(std::min(left, kPart));
    if (paused_ || is_over()) return;
  }
  schedule();
}

// False: more waits than may, and the run is interrupted. One that is interrupted already takes what it has room for.
bool Core::take_inbox() {
  Inbox inbox;
  {
    const services::MutexLock lock(mutex_);
    inbox = std::exchange(inbox_, {});
  }
  if (!started_) return true;  // before the start, nothing is an input
  bool has_dropped = inbox.has_dropped;
  for (services::Delivery& delivery : inbox.deliveries) {
    if (!has_room()) {
      has_dropped = true;
      break;
    }
    const std::size_t units = delivery.units;
    waiting_units_ += units;
    received_units_ += units;
    if (delivery.kind == services::Delivery::Kind::event) {
      execution_.post_event(delivery.key, delivery.name, std::move(delivery.data));
    } else {
      execution_.post_response(delivery.caller.call, delivery.is_error, std::move(delivery.data));
    }
  }
  has_dropped = has_dropped || !keeps_within_bounds();
  if (has_dropped && !interruption_ && !is_over()) {
    interrupt_and_rebuild(
        {ErrorCode::too_large, "more inputs wait, or more of their data is kept, than the server has room for", {}},
        kOverload);
    return false;
  }
  if (paused_ && held_.size() == 0 && !inbox.deliveries.empty()) publish_info();  // how many wait
  return true;
}

// Whether one more input may wait. Their units are counted anew when they may be too many.
bool Core::has_room() {
  const execution::WaitingInputs& waiting = execution_.waiting();
  if (waiting.size() >= kMostInputs) return false;
  if (waiting_units_ <= kMostInputUnits) return true;
  waiting_units_ = 0;
  for (const semantics::Input& input : waiting.inputs()) waiting_units_ += input.data.size_units();
  return waiting_units_ <= kMostInputUnits;
}

// Whether the run keeps no more of what services have said than it may: the newest data of each event, and the last
// response of each call. Counted anew when it may be too much.
bool Core::keeps_within_bounds() {
  if (received_units_ <= kMostKeptUnits) return true;
  received_units_ = run().service_data_units();
  return received_units_ <= kMostKeptUnits;
}

// At most `limit` micro steps of the open macro step, or of a new one. Returns what of the limit is used up.
std::uint32_t Core::do_part(std::uint32_t limit) {
  const std::uint32_t before = execution_.micro();
  const auto begin = Clock::now();
  if (!execution_.is_open()) step_time_ = {};
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(resources_.longest_step - step_time_);
  const Progress* progress = nullptr;
  {
    const auto watch = resources_.watchdog.watch(give_up_, left);
    progress = &next_part(std::min(limit, part_));
  }
  const auto taken = Clock::now() - begin;
  part_ = taken > kTurnTime / 4 ? 1 : std::min(2 * part_, kPart);
  step_time_ += taken;
  if (gave_up()) return limit;
  const std::uint32_t used = std::max(progress->micro - before, 1U);
  take(*progress);
  return used;
}

const Progress& Core::next_part(std::uint32_t limit) {
  if (execution_.is_open()) return execution_.continue_step(limit);
  return run().position() == 0 ? execution_.start(recording(), limit) : execution_.step(recording(), limit);
}

// A macro step that takes several turns is told when it is over, so that it can be given up: nobody has heard of it
// then. Derivations are large.
void Core::take(const Progress& progress) {
  if (progress.reached_goal) paused_ = true;
  if (!progress.untold) return emit(progress);
  if (progress.derivation && progress.micro - progress.first >= kMostUntold) emit(execution_.tell_part());
}

// Whether the macro step under way is over, or the core is paused in it: somebody waits for that, a short time.
bool Core::finish_macro_step() {
  const auto end = Clock::now() + kWaitForStep;
  while (execution_.is_open() && !paused_ && !interruption_ && Clock::now() < end) do_part(kPart);
  return !execution_.is_open() || paused_;
}

// Whether what was computed took too long. It is no fault of the run: the execution is rebuilt.
bool Core::gave_up() {
  if (!*give_up_) return false;
  give_up_macro_step("deadline",
                     "a macro step has taken more than " + std::to_string(resources_.longest_step.count()) + " ms");
  return true;
}

// core/SEMANTICS.md section 10: it is as if it had not begun, unless something of it has been told.
void Core::give_up_macro_step(const char* reason, std::string why) {
  *give_up_ = false;
  step_time_ = {};
  resources_.watcher.printed(id_, "interrupted: " + why);
  interrupt_and_rebuild({ErrorCode::unavailable, std::move(why), {}}, reason);
}

// Who asks learns what the journal has, and nothing that a crash takes back.
void Core::tell_untold() {
  if (!interruption_ && execution_.has_untold()) emit(execution_.tell_part());
}

void Core::hold() {
  tell_untold();
  paused_ = true;
  execution_.set_goal(std::nullopt);
  publish_info();
}

// That the run goes on is stored, too: who resumes it learns whether the disk works.
Expected<void> Core::ready_to_go_on() {
  if (auto sound = readable(); !sound) return sound;
  if (interruption_ && is_over()) end_rebuilt_run();
  if (is_over()) return conflict("core " + id_ + " is over");
  if (!started_) return conflict("core " + id_ + " was not started");
  if (!interruption_) return {};
  interruption_.reset();
  resources_.writer.append(journal_, {.ticket = held_.next_ticket()});
  return {};
}

}  // namespace race::server
