#include "server/execution/core.h"

#include <algorithm>

#include "server/execution/why.h"

namespace race::server {

using semantics::Run;
using semantics::Status;

namespace {

Value integer(std::uint64_t n) { return static_cast<std::int64_t>(n); }

tl::unexpected<Error> conflict(std::string why) { return unexpected(ErrorCode::conflict, std::move(why)); }

}  // namespace

Expected<std::shared_ptr<Core>> Core::create(std::string id, std::string document, JournalHeader header, Pool& pool,
                                             services::Host& host, CoreWatcher& watcher) {
  ASSIGN_OR_RETURN(Run run, Run::create(header.program, header.arguments, header.budgets));
  // Held by the registry, and by work on its way through the strand.
  std::shared_ptr<Core> core(
      new Core(std::move(id), std::move(document), std::move(header), std::move(run), pool, host, watcher));
  return core;
}

void Core::announce() {
  strand_.post([self = shared_from_this()] { self->publish_info(); });
}

Core::Core(std::string id, std::string document, JournalHeader header, Run run, Pool& pool, services::Host& host,
           CoreWatcher& watcher)
    : id_(std::move(id)),
      document_(std::move(document)),
      header_(std::move(header)),
      strand_(pool),
      replay_strand_(pool),
      host_(host),
      watcher_(watcher),
      run_(std::move(run)),
      replay_(std::make_shared<Replay>(header_)) {
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
    while (open_ && goal_.kind == StepGoal::Kind::none && !paused_) micro_step();
    if (!paused_) hold();
    return info_json();
  });
}

Expected<Value> Core::resume() {
  return on_strand([this]() -> Expected<Value> {
    if (is_over()) return conflict("core " + id_ + " is over");
    paused_ = false;
    goal_ = {};
    schedule();
    publish_info();
    return info_json();
  });
}

Expected<Value> Core::stop() {
  return on_strand([this]() -> Expected<Value> {
    if (!started_) return conflict("core " + id_ + " was not started");
    if (is_over()) return conflict("core " + id_ + " is over");
    goal_ = {};
    while (open_) micro_step();
    if (is_over()) return info_json();
    journal_.push_back({JournalEntry::Kind::abort, {}});
    run_.abort();
    complete();
    return info_json();
  });
}

Expected<Value> Core::step(StepGoal goal) {
  return on_strand([this, goal = std::move(goal)]() -> Expected<Value> {
    if (is_over()) return conflict("core " + id_ + " is over");
    if (!started_ || !(paused_ || awaits_input())) return conflict("core " + id_ + " is not paused");
    if (!goal.path.empty()) {
      const auto state = program().find_state(goal.path);
      if (!state) return unexpected(ErrorCode::not_found, "there is no state of this path", goal.path);
      goal_state_ = *state;
      goal_activations_ = run_.state().live[index(*state)].activations;
      goal_active_ = run_.is_active(*state);
    }
    goal_ = goal;
    paused_ = false;
    for (int turn = 0; turn < kTurn && !paused_ && !is_over() && micro_step(); ++turn) {
    }
    schedule();
    publish_info();
    return info_json();
  });
}

Expected<Value> Core::state() {
  return on_strand([this]() -> Expected<Value> {
    Value state = Dict{{"core", info_json()}, {"state", run_.state_json()}};
    return state.freeze();
  });
}

Expected<Value> Core::why(const std::string& port) {
  return on_strand([this, port]() -> Expected<Value> {
    const auto id = program().find_port(port);
    if (!id) return unexpected(ErrorCode::not_found, "there is no port of this path", port);
    Value why = why_json(run_, *id);
    return why.freeze();
  });
}

Expected<Value> Core::why_before(const std::string& port, std::size_t step, int micro) {
  const auto id = program().find_port(port);
  if (!id) return unexpected(ErrorCode::not_found, "there is no port of this path", port);
  ASSIGN_OR_RETURN(JournalView view, journal());
  const std::size_t steps = view.journal.entries.size();
  if (step < 1 || step > steps)
    return unexpected(ErrorCode::out_of_range, "there are macro steps 1 to " + std::to_string(steps), "step");
  const int reached = step == steps && view.micro >= 0 ? std::min(micro, view.micro) : micro;
  auto why = replay_strand_.ask([replay = replay_, view = std::move(view), step, reached, id] {
    Value json = replay->why(view.journal.entries, step, reached, *id);
    return json.freeze();
  });
  if (!why) return unexpected(ErrorCode::unavailable, "the explanation takes long, ask again");
  return std::move(*why);
}

Expected<Core::JournalView> Core::journal() {
  return on_strand([this]() -> Expected<JournalView> {
    return JournalView{{header_, journal_}, open_ ? micro_ : -1, run_.status(), run_.outcome(), run_.fault()};
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
  if (view.status == Status::ended) json.set("outcome", view.outcome);
  if (view.fault) json.set("fault", fault_json(*view.fault));
  auto derived = replay_strand_.ask([replay = replay_, view = std::move(view), from, to, steps] {
    Value list = steps == 0 ? List() : replay->steps(view.journal.entries, from, to, view.micro);
    return list.freeze();
  });
  if (!derived) return unexpected(ErrorCode::unavailable, "the derivations take long, ask again");
  json.set("steps", std::move(*derived));
  return Value(std::move(json));
}

void Core::watch_state() {
  strand_.post([this, self = shared_from_this()] {
    // Those who watch already hear what happened since the last delta: the next one begins at the snapshot.
    if (state_watched_ && open_ && !paused_) publish(false);
    state_watched_ = true;
    Value snapshot = Dict{{"core", info_json()}, {"state", view_.snapshot(run_)}};
    watcher_.state_snapshot(id_, snapshot.freeze());
  });
}

void Core::watch_derivation(bool on) {
  derivation_watched_ = on;
  if (!on) return;
  strand_.post([this, self = shared_from_this()] {
    Value next = Dict{{"next", integer(run_.position() + 1)}};
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
  for (int turn = 0; turn < kTurn; ++turn) {
    if (!micro_step()) return publish_info();
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
      run_.post_event(delivery.key, delivery.name, std::move(delivery.data));
    } else {
      run_.post_response(delivery.caller.call, delivery.is_error, std::move(delivery.data));
    }
  }
}

// One micro step, of a new macro step if none is open. False: no input waits.
bool Core::micro_step() {
  if (!open_) {
    take_inbox();
    if (!run_.has_input()) return false;
    begin();
  }
  semantics::NoRecorder none;
  const bool more = recorder_ ? run_.micro(*recorder_) : run_.micro(none);
  if (state_watched_) view_.look(run_);
  send_calls();
  if (!more || is_over()) {
    complete();
    return true;
  }
  ++micro_;
  if (reached_goal()) hold();
  return true;
}

void Core::begin() {
  JournalEntry entry;
  std::optional<semantics::Input> input;
  if (run_.position() > 0) {
    entry.kind = JournalEntry::Kind::input;
    input = run_.take_input();
    entry.input = *input;
    entry.input.data.freeze();
  }
  journal_.push_back(std::move(entry));
  open_ = true;
  micro_ = 0;
  derived_ = 0;
  recorder_.reset();
  if (derivation_watched_) recorder_.emplace();
  run_.begin(std::move(input));
}

void Core::complete() {
  open_ = false;
  micro_ = 0;
  send_calls();
  if (goal_.kind == StepGoal::Kind::macro) paused_ = true;
  if (paused_ || is_over()) goal_ = {};
  publish(true);
  recorder_.reset();
  if (paused_ || is_over()) publish_info();
}

void Core::send_calls() {
  for (std::string& text : run_.take_printed()) {
    if (text.ends_with('\n')) text.pop_back();
    watcher_.printed(id_, text);
  }
  for (semantics::OutgoingCall& call : run_.take_calls()) {
    host_.call({id_, call.number}, call.service, call.name, call.args, call.kwargs);
    new_calls_.push_back(std::move(call));
  }
}

bool Core::reached_goal() const {
  switch (goal_.kind) {
    case StepGoal::Kind::none:
    case StepGoal::Kind::macro:
      return false;
    case StepGoal::Kind::micro:
      return true;
    case StepGoal::Kind::entered:
      return run_.state().live[index(goal_state_)].activations != goal_activations_;
    case StepGoal::Kind::left: {
      // Activations that could have ended since then, the one that was under way included.
      const std::uint32_t begun =
          run_.state().live[index(goal_state_)].activations - goal_activations_ + (goal_active_ ? 1U : 0U);
      return begun >= 2 || (begun == 1 && !run_.is_active(goal_state_));
    }
  }
  return false;
}

// What was done of an open macro step is told now: a snapshot taken while the core is held loses nobody a part of it.
void Core::hold() {
  paused_ = true;
  goal_ = {};
  if (open_) publish(false);
  publish_info();
}

void Core::publish(bool complete) {
  if (state_watched_) {
    Dict delta{{"core", info_json()}};
    delta.set("input", input_json(program(), journal_.back()));
    for (auto& [key, value] : view_.delta(run_)) delta.set(key, value);
    List calls;
    for (const semantics::OutgoingCall& call : new_calls_) calls.push_back(call_json(call));
    delta.set("calls", std::move(calls));
    Value frozen = std::move(delta);
    watcher_.state_changed(id_, std::move(frozen.freeze()));
  }
  if (recorder_) {
    const semantics::Derivation& derivation = recorder_->derivation;
    List micro, calls;
    for (std::size_t i = derived_; i < derivation.micro.size(); ++i)
      micro.push_back(semantics::derivation_json(program(), derivation, i));
    for (const semantics::OutgoingCall& call : new_calls_) calls.push_back(call_json(call));
    Dict step{{"step", integer(run_.position())}, {"input", input_json(program(), journal_.back())},
              {"micro", std::move(micro)},        {"calls", std::move(calls)},
              {"first", integer(derived_)},       {"complete", complete}};
    derived_ = derivation.micro.size();
    Value steps = Dict{{"steps", List{Value(std::move(step))}}};
    watcher_.derived(id_, std::move(steps.freeze()));
  }
  new_calls_.clear();
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
  Dict info{{"id", id_},
            {"document", document_},
            {"status", started_ ? Value(semantics::name(run_.status())) : Value("ready")},
            {"paused", (paused_ || awaits_input()) && !over},
            {"stepping", goal_.kind != StepGoal::Kind::none && !over},
            {"step", integer(run_.position())},
            {"micro", micro_},
            {"waiting", integer(run_.state().waiting.size())},
            {"arguments", header_.arguments}};
  if (run_.status() == Status::ended) info.set("outcome", run_.outcome());
  if (over) info.set("results", root_results(run_));
  if (run_.fault()) info.set("fault", fault_json(*run_.fault()));
  Value frozen = std::move(info);
  return std::move(frozen.freeze());
}

}  // namespace race::server
