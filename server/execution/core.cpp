#include "server/execution/core.h"

#include <algorithm>

#include "core/execution/step_json.h"
#include "core/execution/why.h"

namespace race::server {

using execution::Execution;
using execution::Goal;
using execution::Progress;

namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

Value breakpoints_json(const std::vector<execution::GoalName>& breakpoints) {
  List list;
  for (const execution::GoalName& each : breakpoints)
    list.push_back(Dict{{"when", execution::name(each.kind)}, {each.id ? "id" : "path", each.id.value_or(each.path)}});
  Value json(std::move(list));
  return std::move(json.freeze());
}

tl::unexpected<Error> conflict(std::string why) { return unexpected(ErrorCode::conflict, std::move(why)); }

}  // namespace

Expected<std::shared_ptr<Core>> Core::create(std::string id, std::string document, execution::JournalHeader header,
                                             Pool& pool, services::Host& host, CoreWatcher& watcher) {
  ASSIGN_OR_RETURN(Execution execution, Execution::create(header.program, header.arguments, header.budgets));
  // Held by the registry, and by work on its way through the strand.
  std::shared_ptr<Core> core(
      new Core(std::move(id), std::move(document), std::move(header), std::move(execution), pool, host, watcher));
  return core;
}

void Core::announce() {
  strand_.post([self = shared_from_this()] { self->publish_info(); });
}

Core::Core(std::string id, std::string document, execution::JournalHeader header, Execution execution, Pool& pool,
           services::Host& host, CoreWatcher& watcher)
    : id_(std::move(id)),
      document_(std::move(document)),
      header_(std::move(header)),
      strand_(pool),
      replay_strand_(pool),
      host_(host),
      watcher_(watcher),
      execution_(std::move(execution)) {
  info_ = info_json();
}

template <typename F>
auto Core::on_strand(F function) -> std::invoke_result_t<F> {
  auto answer = strand_.ask([self = shared_from_this(), function = std::move(function)] { return function(); });
  if (!answer) return unexpected(ErrorCode::unavailable, "core " + id_ + " is busy");
  return std::move(*answer);
}

Value Core::info() const {
  const services::MutexLock lock(mutex_);
  return info_;
}

void Core::deliver(const services::Delivery& delivery) {
  {
    const services::MutexLock lock(mutex_);
    inbox_.push_back(delivery);
    if (inbox_.size() > 1) return;  // who put the first one has woken it
  }
  strand_.post([self = shared_from_this()] { self->advance(); });
}

Expected<Value> Core::start() {
  return on_strand([this]() -> Expected<Value> {
    if (started_) return conflict("core " + id_ + " was started before");
    started_ = true;
    schedule();
    publish_info();
    return info_json();
  });
}

Expected<Value> Core::pause() {
  return on_strand([this]() -> Expected<Value> {
    if (is_over()) return conflict("core " + id_ + " is over");
    while (execution_.is_open() && !execution_.has_goal() && !paused_) do_part(Execution::kNoLimit);
    if (!paused_) hold();
    return info_json();
  });
}

Expected<Value> Core::resume() {
  return on_strand([this]() -> Expected<Value> {
    if (is_over()) return conflict("core " + id_ + " is over");
    paused_ = false;
    execution_.set_goal(std::nullopt);
    schedule();
    publish_info();
    return info_json();
  });
}

Expected<Value> Core::stop() {
  return on_strand([this]() -> Expected<Value> {
    if (!started_) return conflict("core " + id_ + " was not started");
    if (is_over()) return conflict("core " + id_ + " is over");
    execution_.set_goal(std::nullopt);
    execution_.set_breakpoints({});
    while (execution_.is_open()) do_part(Execution::kNoLimit);
    if (!is_over()) emit(execution_.abort());
    return info_json();
  });
}

Expected<Value> Core::step(execution::GoalName name) {
  return on_strand([this, name = std::move(name)]() -> Expected<Value> {
    if (is_over()) return conflict("core " + id_ + " is over");
    if (!started_ || !(paused_ || awaits_input())) return conflict("core " + id_ + " is not paused");
    ASSIGN_OR_RETURN(const Goal goal, find_goal(program(), name));
    execution_.set_goal(goal);
    paused_ = false;
    advance();
    publish_info();
    return info_json();
  });
}

Expected<Value> Core::set_breakpoints(std::vector<execution::GoalName> names) {
  return on_strand([this, names = std::move(names)]() -> Expected<Value> {
    if (is_over()) return conflict("core " + id_ + " is over");
    if (names.size() > kMostBreakpoints)
      return unexpected(ErrorCode::too_large, "there may be " + std::to_string(kMostBreakpoints) + " breakpoints",
                        "breakpoints");
    std::vector<Goal> goals;
    for (const execution::GoalName& name : names) {
      const auto goal = find_goal(program(), name);
      if (!goal)
        return unexpected(goal.error().code, goal.error().message, "breakpoints/" + std::to_string(goals.size()));
      goals.push_back(*goal);
    }
    execution_.set_breakpoints(goals);
    breakpoints_ = breakpoints_json(names);
    publish_info();
    return info_json();
  });
}

Expected<Value> Core::state() {
  return on_strand([this]() -> Expected<Value> {
    Value state = Dict{{"core", info_json()}, {"state", run().state_json()}};
    return state.freeze();
  });
}

Expected<Value> Core::why(const std::string& port) {
  return on_strand([this, port]() -> Expected<Value> {
    const auto id = program().find_port(port);
    if (!id) return unexpected(ErrorCode::not_found, "there is no port of this path", port);
    Value why = why_json(execution_, *id);
    return why.freeze();
  });
}

// `function` of the replay and the journal, on the strand of replays.
template <typename F>
Expected<Value> Core::replayed(const execution::Journal& journal, F function) {
  auto replay =
      std::make_shared<execution::Replay>(journal.header, std::make_shared<execution::MemoryJournal>(journal.entries));
  auto answer = replay_strand_.ask([replay, function = std::move(function)]() -> Expected<Value> {
    ASSIGN_OR_RETURN(Value json, function(*replay));
    return json.freeze();
  });
  if (!answer) return unexpected(ErrorCode::unavailable, "the replay takes long, ask again");
  return std::move(*answer);
}

Expected<Value> Core::why_before(const std::string& port, std::size_t step, int micro) {
  const auto id = program().find_port(port);
  if (!id) return unexpected(ErrorCode::not_found, "there is no port of this path", port);
  ASSIGN_OR_RETURN(JournalView view, journal());
  const std::size_t steps = view.journal.entries.size();
  if (step < 1 || step > steps)
    return unexpected(ErrorCode::out_of_range, "there are macro steps 1 to " + std::to_string(steps), "step");
  const int reached = step == steps && view.micro >= 0 ? std::min(micro, view.micro) : micro;
  return replayed(view.journal, [step, reached, id](execution::Replay& replay) -> Expected<Value> {
    ASSIGN_OR_RETURN(Execution past, replay.before(step, reached));
    return why_json(past, *id);
  });
}

Expected<Core::JournalView> Core::journal() {
  return on_strand([this]() -> Expected<JournalView> {
    const int micro = execution_.is_open() ? static_cast<int>(execution_.micro()) : -1;
    return JournalView{{header_, journal_}, micro, run().status(), run().outcome(), run().fault()};
  });
}

Expected<Value> Core::derivations(std::size_t from, std::size_t to) {
  ASSIGN_OR_RETURN(JournalView view, journal());
  const std::size_t steps = view.journal.entries.size();
  if (from == 0) from = steps;
  if (to == 0) to = from;
  if (steps > 0 && (from > to || to > steps || to - from >= 100))
    return unexpected(ErrorCode::out_of_range,
                      "macro steps 1 to " + std::to_string(steps) + " can be had, at most 100 at once");
  Dict json{{"status", semantics::name(view.status)}};
  if (view.status == semantics::Status::ended) json.set("outcome", view.outcome);
  if (view.fault) json.set("fault", execution::fault_json(*view.fault));
  ASSIGN_OR_RETURN(Value derived,
                   replayed(view.journal, [=, micro = view.micro](execution::Replay& replay) -> Expected<Value> {
                     if (steps == 0) return List();
                     return replay.steps(from, to, steps, micro);
                   }));
  json.set("steps", std::move(derived));
  return Value(std::move(json));
}

void Core::watch_state() {
  strand_.post([this, self = shared_from_this()] {
    state_watched_ = true;
    Value snapshot = Dict{{"core", info_json()}, {"state", execution_.watch()}};
    watcher_.state_snapshot(id_, snapshot.freeze());
  });
}

void Core::watch_derivation(bool on) {
  derivation_watched_ = on;
  if (!on) return;
  strand_.post([this, self = shared_from_this()] {
    Value next = Dict{{"next", integer(run().position() + 1)}};
    watcher_.derivation_snapshot(id_, next.freeze());
  });
}

void Core::schedule() {
  if (std::exchange(scheduled_, true)) return;
  strand_.post([self = shared_from_this()] {
    self->scheduled_ = false;
    self->advance();
  });
}

// One turn: as many micro steps as are its due, then the others on this pool.
void Core::advance() {
  take_inbox();
  if (!started_ || paused_ || closed_ || is_over()) return;
  for (std::uint32_t left = kTurn; left > 0;) {
    if (!execution_.is_open()) take_inbox();
    if (!execution_.is_open() && !has_input()) return publish_info();
    left -= do_part(left);
    if (paused_ || is_over()) return;
  }
  schedule();
}

void Core::take_inbox() {
  std::vector<services::Delivery> inbox;
  {
    const services::MutexLock lock(mutex_);
    inbox.swap(inbox_);
  }
  if (!started_) return;  // before the start, nothing is an input
  for (services::Delivery& delivery : inbox) {
    if (delivery.kind == services::Delivery::Kind::event) {
      execution_.post_event(delivery.key, delivery.name, std::move(delivery.data));
    } else {
      execution_.post_response(delivery.caller.call, delivery.is_error, std::move(delivery.data));
    }
  }
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

// What came of a part of a macro step leaves the core.
void Core::emit(const Progress& progress) {
  if (progress.first == 0 && progress.entry) journal_.push_back(*progress.entry);
  for (const std::string& text : progress.printed) watcher_.printed(id_, text);
  for (const semantics::OutgoingCall& call : progress.calls)
    host_.call({id_, call.number}, call.service, call.name, call.args, call.kwargs);
  publish(progress);
  if (paused_ || is_over()) publish_info();
}

void Core::hold() {
  paused_ = true;
  execution_.set_goal(std::nullopt);
  publish_info();
}

void Core::publish(const Progress& progress) {
  if (state_watched_) {
    Dict delta{{"core", info_json()}};
    if (progress.entry) delta.set("input", input_json(*progress.entry));
    for (const auto& [key, value] : progress.delta) delta.set(key, value);
    delta.set("calls", execution::calls_json(progress.calls));
    Value frozen = std::move(delta);
    watcher_.state_changed(id_, std::move(frozen.freeze()));
  }
  if (progress.derivation) {
    Dict step = trace_step(program(), progress);
    step.set("first", integer(progress.first));
    step.set("complete", progress.complete);
    Value steps = Dict{{"steps", List{Value(std::move(step))}}};
    watcher_.derived(id_, std::move(steps.freeze()));
  }
}

void Core::publish_info() {
  Value info = info_json();
  {
    const services::MutexLock lock(mutex_);
    info_ = info;
  }
  // Counters move with every input; the list of cores hears of what else changes.
  Dict news = info.as_dict();
  for (const char* counter : {"step", "micro", "waiting"}) news.erase(counter);
  if (Value(news) == announced_) return;
  announced_ = std::move(news);
  watcher_.core_changed(id_, std::move(info));
}

Value Core::info_json() const {
  const bool over = is_over();
  Dict info{{"id", id_}, {"document", document_}};
  execution::set_status(run(), info);
  if (!started_) info.set("status", "ready");
  info.set("paused", (paused_ || awaits_input()) && !over);
  info.set("stepping", execution_.has_goal() && !over);
  info.set("step", integer(run().position()));
  info.set("micro", integer(execution_.micro()));
  info.set("waiting", integer(execution_.waiting().size()));
  info.set("arguments", header_.arguments);
  info.set("breakpoints", breakpoints_);
  if (over) info.set("results", execution::root_results(run()));
  Value frozen = std::move(info);
  return std::move(frozen.freeze());
}

}  // namespace race::server
