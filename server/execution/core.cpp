#include "server/execution/core.h"

#include <algorithm>

#include "server/execution/core_internal.h"
#include "server/wire/calendar.h"

namespace race::server {

using execution::Execution;
using execution::Goal;

namespace {

tl::unexpected<Error> conflict(std::string why) { return unexpected(ErrorCode::conflict, std::move(why)); }

/// Whether the program has them all, or what is wrong with the first that it has not.
Expected<void> check_goals(const semantics::Program& program, const std::vector<execution::GoalName>& names) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto goal = find_goal(program, names[i]); !goal)
      return unexpected(goal.error().code, goal.error().message,
                        "breakpoints/" + std::to_string(i) + "/" + goal.error().path);
  return {};
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
      timing_(now_ms() - record_.created_ms, record_.steps),
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
    inbox_.times.push_back(TimingRecorder::Clock::now());
    if (std::exchange(inbox_.woken, true)) return;
  }
  try {
    post_turn([this] { advance(); });
  } catch (...) {  // no memory: who delivers next wakes it
    const services::MutexLock lock(mutex_);
    inbox_.woken = false;
    throw;
  }
}

// The first macro step begins at once, so that the answer says that it has.
void Core::start(Done<Value> done, Supervision by) {
  when_rebuilt<Value>(std::move(done), [this, by]() -> Expected<Value> {
    if (started_) return conflict("core " + id_ + " was started before");
    if (closed_) return conflict("core " + id_ + " has another model now");
    if (auto free = take_fence(by); !free) return tl::unexpected(std::move(free).error());
    started_ = true;
    note_services();
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
    return Preparation{paused_, breakpoints_};
  });
}

// Not on the strand: nobody knows this core yet. What is shown of it has all of this from the first moment.
void Core::replace(const Core& other, Preparation preparation) {
  breakpoints_ = std::move(preparation.breakpoints);
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

void Core::resume(Done<Value> done, Supervision by) {
  when_rebuilt<Value>(std::move(done), [this, by]() -> Expected<Value> {
    if (started_ || interruption_) {
      if (auto free = take_fence(by); !free) return tl::unexpected(std::move(free).error());
      if (auto ready = ready_to_go_on(); !ready) return tl::unexpected(std::move(ready).error());
    }
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
    if (answer || !self->ends_later_) return done(answer);
    self->end_when_rebuilt(done);
  };
  if (ends_later_) return end_when_rebuilt(std::move(done));
  when_rebuilt<Value>(std::move(stopped), [this]() -> Expected<Value> {
    if (!started_) return conflict("core " + id_ + " was not started");
    if (auto ended = end_run_now(); !ended) return tl::unexpected(std::move(ended).error());
    return info_json();
  });
}

void Core::end_when_rebuilt(Done<Value> done) {
  on_strand<Value>(std::move(done), [this]() -> Expected<Value> {
    if (auto ended = end_run_now(); !ended) return tl::unexpected(std::move(ended).error());
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

// One that is given up now, has received too much, or takes long to be read back, ends when it is.
Expected<void> Core::end_run_now() {
  if (ends_later_) {
    if (!is_stopped_.exchange(true)) *end_last_step_ = true;  // nobody waits for what that comes to
    if (is_to_rebuild() && !interruption_->rebuilding) rebuild_later();
    return {};
  }
  if (auto ready = ready_to_go_on(); !ready) return ready;
  execution_.set_goal(std::nullopt);
  execution_.set_breakpoints({});
  paused_ = false;  // it may have stopped within the macro step
  if (!finish_macro_step()) give_up_macro_step("stopped", "it was stopped in a long macro step");
  if (interruption_) {
    is_stopped_ = ends_later_ = true;
    return {};
  }
  if (!is_over()) emit(execution_.abort());
  return {};
}

void Core::step(execution::GoalName name, Done<Value> done, Supervision by) {
  when_rebuilt<Value>(std::move(done), [this, by, name = std::move(name)]() -> Expected<Value> {
    do_turn_before();
    if (is_over() && !interruption_) return conflict("core " + id_ + " is over");
    if (!started_ || !(paused_ || awaits_input())) return conflict("core " + id_ + " is not paused");
    ASSIGN_OR_RETURN(const Goal goal, find_goal(program(), name));
    if (auto free = take_fence(by); !free) return tl::unexpected(std::move(free).error());
    if (auto ready = ready_to_go_on(); !ready) return tl::unexpected(std::move(ready).error());
    execution_.set_goal(goal);
    paused_ = false;
    advance();
    publish_info();
    return info_json();
  });
}

void Core::set_breakpoints(std::vector<execution::GoalName> names, std::string author, Done<Value> done) {
  on_strand<Value>(std::move(done), [this, names = std::move(names), author = std::move(author)]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    if (is_over()) return conflict("core " + id_ + " is over");
    std::vector<Breakpoint> all;
    for (const Breakpoint& each : breakpoints_)
      if (!author.empty() && each.author != author) all.push_back(each);
    for (const execution::GoalName& name : names) all.push_back({name, author});
    if (all.size() > kMostBreakpoints)
      return unexpected(ErrorCode::too_large,
                        "there may be " + std::to_string(kMostBreakpoints) + " breakpoints, with those of others",
                        "breakpoints");
    if (auto found = check_goals(program(), names); !found) return tl::unexpected(std::move(found).error());
    breakpoints_ = std::move(all);
    find_breakpoints();
    publish_info();
    return info_json();
  });
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
// A person wants that it goes on: what it says from here on may move. From the moment the gate has said so, that person
// may be lost: what is asked of it since then is done.
Expected<void> Core::take_fence(const Supervision& by) {
  const bool supervised = by.supervised.value_or(supervised_);
  const bool was_asked = hold_asked_.exchange(false);
  const auto fence = resources_.host.gate().begin({id_, by.control, supervised});
  if (!fence && was_asked) hold_asked_ = true;
  if (!fence) return tl::unexpected(fence.error());
  fence_ = *fence;
  supervised_ = supervised;
  return {};
}

// The turn that takes an input looks for what is asked here first.
void Core::hold_at_once() {
  hold_asked_ = true;
  post_turn([this] { advance(); });
}

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
