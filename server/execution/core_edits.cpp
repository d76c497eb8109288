// Edits of a running core, and what a person sets in it (core/SEMANTICS.md section 9). They are delivered between macro
// steps; an edit that cannot be waits, and everyone sees for what.
#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/execution/step_json.h"
#include "server/execution/core_internal.h"
#include "server/wire/errors.h"

namespace race::server {

namespace {

/// The state for which the edit waits, if it is one that is active: until it is left, nobody need try again.
std::optional<semantics::StateId> state_of(const semantics::Program& program,
                                           const std::vector<semantics::Obstacle>& obstacles) {
  const semantics::Obstacle& first = obstacles.front();
  if (first.kind != semantics::Obstacle::Kind::active) return std::nullopt;
  return first.id.empty() ? program.find_state(first.path) : program.state_with_id(first.id);
}

}  // namespace

execution::ExecutedModel Core::model() const {
  const services::MutexLock lock(mutex_);
  return model_;
}

bool Core::names_event(const std::string& service, const std::string& event) const {
  const services::MutexLock lock(mutex_);
  return model_.program->names_event(model_.program->services.find_event(service, event));
}

void Core::set_model(execution::ExecutedModel model) {
  const services::MutexLock lock(mutex_);
  model_ = std::move(model);
}

void Core::native(Done<Value> done) {
  on_strand<Value>(std::move(done), [this]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    return execution_.model().native;
  });
}

void Core::set_live(bool live, Done<Value> done) {
  on_strand<Value>(std::move(done), [this, live]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    if (is_over()) return unexpected(ErrorCode::conflict, "core " + id_ + " is over");
    live_ = live;
    if (!live) {
      edit_.reset();
      refused_edit_ = Value::unknown();
    }
    publish_info();
    return info_json();
  });
}

void Core::confirm_edit(std::int64_t revision, Done<Value> done) {
  on_strand<Value>(std::move(done), [this, revision]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    if (!edit_ || edit_->edit.revision != revision)
      return unexpected(ErrorCode::conflict, "no edit to revision " + std::to_string(revision) + " waits");
    edit_->confirmed = true;
    edit_->unconfirmed = false;
    publish_info();
    schedule();
    return info_json();
  });
}

void Core::reinstate() {
  closed_ = false;
  strand_.post([self = shared_from_this()] { self->follow_again(); });
}

void Core::follow(LiveEdit edit) {
  strand_.post([self = shared_from_this(), edit = std::move(edit)]() mutable { self->take_edit(std::move(edit)); });
}

void Core::refuse_edit(std::int64_t revision, const std::vector<Error>& errors) {
  Dict json{{"revision", revision}};
  set_errors(json, errors);
  Value refused(std::move(json));
  strand_.post([self = shared_from_this(), refused = refused.freeze()] {
    if (!self->live_ || self->closed_ || self->is_over()) return;
    self->edit_.reset();
    self->refused_edit_ = refused;
    self->publish_info();
  });
}

// One that waits gives way to a later one, which has it in it.
void Core::take_edit(LiveEdit edit) {
  if (!live_ || is_over()) return;
  follow_again_ = edit.stale;
  if (closed_) return;
  if (edit.base != execution_.model().program) return edit.stale();
  edit_.reset();
  refused_edit_ = Value::unknown();
  if (edit.changes_nothing()) {
    revision_ = edit.revision;
  } else {
    edit_.emplace(WaitingEdit{.edit = std::move(edit), .waits = {}, .state = std::nullopt});
    if (!execution_.is_open() && run().position() > 0) look_ahead();
  }
  publish_info();
  schedule();
}

// An edit that was delivered may be lost with its entry, and one that comes to a closed core is not taken: who brings
// them learns that this core needs the last one anew.
void Core::follow_again() {
  if (live_ && !closed_ && follow_again_) follow_again_();
}

// What it waits for, though nothing can begin now.
void Core::look_ahead() {
  const auto edited = run().edited(edit_->edit.model.program);
  if (!edited) note_obstacles(edited.error());
}

void Core::note_obstacles(const std::vector<semantics::Obstacle>& obstacles) {
  edit_->state = state_of(program(), obstacles);
  List waits = execution::obstacles_json(obstacles);
  if (waits == edit_->waits) return;
  edit_->waits = std::move(waits);
  publish_info();
}

// Whether it was delivered, as a macro step of its own. Between macro steps.
bool Core::deliver_edit(std::uint32_t limit) {
  if (!edit_ || run().position() == 0) return false;
  if (edit_->edit.base != execution_.model().program) {
    edit_->edit.stale();
    edit_.reset();
    return false;
  }
  if (edit_->state && run().is_active(*edit_->state)) return false;
  // One that has waited for it once waits until somebody says so, also when who was asked is gone.
  if (!edit_->confirmed && (edit_->unconfirmed || resources_.host.gate().confirms_edits(id_))) {
    if (!std::exchange(edit_->unconfirmed, true)) publish_info();
    return false;
  }
  const LiveEdit& edit = edit_->edit;
  const std::vector<std::uint64_t> open_calls = run().unanswered_calls();
  const auto watch = resources_.watchdog.watch(give_up_, resources_.longest_step);
  auto progress = execution_.edit(edit.entry, edit.model, recording(), limit);
  if (gave_up()) return true;
  if (!progress) {
    note_obstacles(progress.error());
    return false;
  }
  revision_ = edit.revision;
  model_since_ = run().position();
  edit_.reset();
  set_model(execution_.model());
  find_breakpoints();
  step_time_ = {};
  take(**progress);
  abandon_unless_open(open_calls);
  publish_info();
  return true;
}

// The calls of callers that an edit has removed are dropped.
void Core::abandon_unless_open(const std::vector<std::uint64_t>& calls) {
  const std::vector<std::uint64_t> open = run().unanswered_calls();
  std::vector<std::uint64_t> dropped;
  std::ranges::set_difference(calls, open, std::back_inserter(dropped));
  held_.add([this, dropped = std::move(dropped)](const Error* failure) {
    if (failure) return;
    for (const std::uint64_t call : dropped) resources_.host.abandon({id_, call});
  });
}

// Those that the model has, also for the execution, which keeps those of the same elements: a name stays as it was
// given, and means what it names now.
void Core::find_breakpoints() {
  reached_breakpoints_.clear();
  std::vector<execution::Goal> goals;
  std::erase_if(breakpoints_, [&](const Breakpoint& each) {
    const auto goal = find_goal(program(), each.goal);
    if (goal) goals.push_back(*goal);
    return !goal;
  });
  execution_.set_breakpoints(goals);
}

// A person's command: it takes effect at once, also in a core that is paused, which stays so.
void Core::force(semantics::Force force, Done<Value> done, std::uint64_t control) {
  force.value.freeze();
  when_rebuilt<Value>(std::move(done), [this, control, force = std::move(force)]() -> Expected<Value> {
    if (auto sound = readable(); !sound) return tl::unexpected(std::move(sound).error());
    if (interruption_) return unexpected(ErrorCode::conflict, "core " + id_ + " is interrupted");
    if (!started_ || is_over()) return unexpected(ErrorCode::conflict, "core " + id_ + " is not running");
    if (auto may = resources_.host.gate().may_force({id_, control, supervised_}); !may)
      return tl::unexpected(std::move(may).error());
    if (!finish_macro_step()) return unexpected(ErrorCode::conflict, "core " + id_ + " is in a long macro step");
    if (execution_.is_open()) return unexpected(ErrorCode::conflict, "core " + id_ + " is paused in a macro step");
    if (is_over()) return unexpected(ErrorCode::conflict, "core " + id_ + " is over");
    const auto watch = resources_.watchdog.watch(give_up_, resources_.longest_step);
    ASSIGN_OR_RETURN(const execution::Progress* progress, execution_.force(force, recording(), kPart));
    if (gave_up()) return unexpected(ErrorCode::unavailable, interruption_->message);
    step_time_ = {};
    take(*progress);
    schedule();
    publish_info();
    return info_json();
  });
}

Dict Core::edit_info() const {
  Dict info;
  info.set("live", live_.load());
  info.set("model", static_cast<std::int64_t>(model_since_));
  if (is_over()) return info;
  if (edit_) {
    Dict waiting{{"revision", edit_->edit.revision}, {"waits", edit_->waits}};
    if (edit_->unconfirmed) waiting.set("unconfirmed", true);
    info.set("waiting_edit", std::move(waiting));
  }
  if (!refused_edit_.is_unknown()) info.set("refused_edit", refused_edit_);
  return info;
}

}  // namespace race::server
