#include "server/execution/core.h"

#include <algorithm>
#include <tuple>

#include "server/execution/core_internal.h"

namespace race::server {

using execution::Execution;
using execution::Goal;
using execution::Progress;

namespace {

tl::unexpected<Error> conflict(std::string why) { return unexpected(ErrorCode::conflict, std::move(why)); }

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
                                             const CoreResources& resources) {
  ASSIGN_OR_RETURN(Execution execution, Execution::create(header));
  // Held by the registry, and by work on its way through the strand.
  std::shared_ptr<Core> core(new Core(std::move(run), std::move(header), std::move(execution), resources));
  core->open_journal();
  return core;
}

Core::Core(RunRecord run, execution::JournalHeader header, Execution execution, const CoreResources& resources)
    : id_(std::to_string(run.id)),
      run_id_(run.id),
      header_(std::move(header)),
      resources_(resources),
      strand_(resources.pool),
      model_(execution.model()),
      record_(std::move(run)),
      execution_(std::move(execution)),
      replay_(std::make_shared<execution::Replay>(header_, resources.runs.source(run_id_))) {
  revision_ = record_.revision;
  info_ = info_json();
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
    inbox_.units += delivery.data.size_units();
    inbox_.deliveries.push_back(delivery);
    if (inbox_.deliveries.size() > 1) return;  // who put the first one has woken it
  }
  strand_.post([self = shared_from_this()] { self->advance(); });
}

// The first macro step begins at once, so that the answer says that it has.
Expected<Value> Core::start() {
  if (auto ready = ensure_rebuilt(); !ready) return tl::unexpected(std::move(ready).error());
  return on_strand<Value>([this]() -> Expected<Value> {
    if (started_) return conflict("core " + id_ + " was started before");
    if (closed_) return conflict("core " + id_ + " has another model now");
    started_ = true;
    advance();
    publish_info();
    return info_json();
  });
}

Expected<Core::Preparation> Core::retire() {
  return on_strand<Preparation>([this]() -> Expected<Preparation> {
    if (started_) return conflict("core " + id_ + " was started before");
    if (closed_) return conflict("core " + id_ + " is going away");
    closed_ = true;
    return Preparation{paused_, breakpoint_names_};
  });
}

// What is shown of it has all of this from the first moment: `live_` stands before what publishes it.
void Core::replace(const Core& other, Preparation preparation) {
  live_ = other.live_.load();
  std::erase_if(preparation.breakpoints,
                [this](const execution::GoalName& name) { return !find_goal(*header_.program, name).has_value(); });
  std::ignore = set_breakpoints(std::move(preparation.breakpoints));
  if (preparation.paused) std::ignore = pause();
  if (other.state_watched_) watch_state();
  if (other.derivation_watched_) watch_derivation(true);
}

Expected<Value> Core::pause() {
  return on_strand<Value>([this]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    if (is_over()) return conflict("core " + id_ + " is over");
    while (execution_.is_open() && !execution_.has_goal() && !paused_) do_part(Execution::kNoLimit);
    if (!paused_) hold();
    return info_json();
  });
}

Expected<Value> Core::resume() {
  if (auto ready = ensure_rebuilt(); !ready) return tl::unexpected(std::move(ready).error());
  return on_strand<Value>([this]() -> Expected<Value> {
    if (started_ || interruption_)
      if (auto ready = ready_to_go_on(); !ready) return tl::unexpected(std::move(ready).error());
    paused_ = false;
    execution_.set_goal(std::nullopt);
    schedule();
    publish_info();
    return info_json();
  });
}

Expected<Value> Core::stop() {
  if (auto ready = ensure_rebuilt(); !ready) return tl::unexpected(std::move(ready).error());
  return on_strand<Value>([this]() -> Expected<Value> {
    if (!started_) return conflict("core " + id_ + " was not started");
    if (auto ended = end_run_now(); !ended) return tl::unexpected(std::move(ended).error());
    return info_json();
  });
}

Expected<bool> Core::dismiss() {
  if (auto ready = ensure_rebuilt(); !ready) return tl::unexpected(std::move(ready).error());
  return on_strand<bool>([this]() -> Expected<bool> {
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
  while (execution_.is_open()) do_part(Execution::kNoLimit);
  if (!is_over()) emit(execution_.abort());
  return {};
}

Expected<Value> Core::step(execution::GoalName name) {
  if (auto ready = ensure_rebuilt(); !ready) return tl::unexpected(std::move(ready).error());
  return on_strand<Value>([this, name = std::move(name)]() -> Expected<Value> {
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

Expected<Value> Core::set_breakpoints(std::vector<execution::GoalName> names) {
  return on_strand<Value>([this, names = std::move(names)]() -> Expected<Value> {
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
  post_work([this] {
    scheduled_ = false;
    advance();
  });
}

// One turn: as many micro steps as are its due, then the others on this pool. Too far ahead of the disk, it is left
// until that has caught up (durable()).
void Core::advance() {
  if (!take_inbox()) return;
  if (!started_ || paused_ || closed_ || is_over()) return;
  for (std::uint32_t left = kTurn; left > 0;) {
    if (held_.size() >= kMostHeld) return;
    if (!execution_.is_open() && !take_inbox()) return;
    if (!execution_.is_open() && deliver_edit(left)) {
      if (paused_ || is_over()) return;
      continue;
    }
    if (!execution_.is_open() && !has_input()) return publish_info();
    left -= do_part(left);
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
    waiting_units_ += delivery.data.size_units();
    if (delivery.kind == services::Delivery::Kind::event) {
      execution_.post_event(delivery.key, delivery.name, std::move(delivery.data));
    } else {
      execution_.post_response(delivery.caller.call, delivery.is_error, std::move(delivery.data));
    }
  }
  if (has_dropped && !interruption_ && !is_over()) {
    interrupt_and_rebuild({ErrorCode::too_large, "more inputs wait than the server keeps", {}}, "overload");
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

// At most `limit` micro steps of the open macro step, or of a new one. Returns what of the limit is used up.
std::uint32_t Core::do_part(std::uint32_t limit) {
  const Progress& progress = next_part(limit);
  const std::uint32_t used = std::max(progress.micro - progress.first, 1U);
  if (progress.reached_goal) paused_ = true;
  emit(progress);
  return used;
}

const Progress& Core::next_part(std::uint32_t limit) {
  if (execution_.is_open()) return execution_.continue_step(limit);
  const execution::Recording recording{.derivation = derivation_watched_};
  return run().position() == 0 ? execution_.start(recording, limit) : execution_.step(recording, limit);
}

void Core::hold() {
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
