#include "server/queue/run_queue.h"

#include <algorithm>
#include <utility>

#include "services/failures.h"

namespace race::server {

using services::MutexLock;

namespace {

Error not_queued(const std::string& id) { return {ErrorCode::not_found, "there is no queued run of this id", id}; }

constexpr const char* kLostControls = "who queued it has the controls no more";

Error of_another_store() { return {ErrorCode::conflict, "a backup was restored meanwhile", {}}; }

}  // namespace

Expected<QueuedRun> RunQueue::add(QueuedTask task) {
  if (Value(task.arguments).size_units() > kMostArgumentUnits)
    return unexpected(ErrorCode::too_large, "the arguments of a queued run are too large", "arguments");
  task.arguments.freeze();
  const std::uint64_t stops = control_.stops();
  const MutexLock lock(mutex_);
  if (task.restores != restores_) return tl::unexpected(of_another_store());
  if (count(QueuedStatus::waiting) >= kMostWaiting)
    return unexpected(ErrorCode::conflict, std::to_string(kMostWaiting) + " runs wait already");
  const bool is_idle = current_ == 0 && !pause_ && count(QueuedStatus::waiting) == 0;
  if (is_idle) stops_ = stops;
  runs_.push_back({.id = ++last_id_, .task = std::move(task)});
  post_next();
  return runs_.back();
}

std::uint64_t RunQueue::restores() const {
  const MutexLock lock(mutex_);
  return restores_;
}

RunQueue::Entries::const_iterator RunQueue::find_run(const std::string& id) const {
  return std::ranges::find(runs_, id, [](const QueuedRun& run) { return std::to_string(run.id); });
}

QueuedRun* RunQueue::current() {
  const auto run = std::ranges::find(runs_, current_, &QueuedRun::id);
  return run == runs_.end() ? nullptr : &*run;
}

std::size_t RunQueue::count(QueuedStatus status) const {
  return static_cast<std::size_t>(std::ranges::count(runs_, status, &QueuedRun::status));
}

Expected<QueuedRun> RunQueue::find(const std::string& id) const {
  const MutexLock lock(mutex_);
  const auto run = find_run(id);
  if (run == runs_.end()) return tl::unexpected(not_queued(id));
  return *run;
}

Expected<QueuedRun> RunQueue::cancel(const std::string& id) {
  const MutexLock lock(mutex_);
  const auto found = find_run(id);
  if (found == runs_.end()) return tl::unexpected(not_queued(id));
  QueuedRun& run = runs_[static_cast<std::size_t>(found - runs_.begin())];
  if (run.status != QueuedStatus::waiting)
    return unexpected(ErrorCode::conflict, "it does not wait any more; a run is stopped at its core", id);
  run.status = QueuedStatus::cancelled;
  QueuedRun cancelled = run;
  forget_oldest();
  return cancelled;
}

Expected<void> RunQueue::resume() {
  const std::uint64_t stops = control_.stops();
  if (const auto stopped = control_.stopped())
    return unexpected(ErrorCode::stopped, "the cell was stopped by " + stopped->by + "; reset the stop first");
  const MutexLock lock(mutex_);
  pause_.reset();
  stops_ = stops;
  post_next();
  return {};
}

Value RunQueue::json(std::int64_t after, std::size_t most) const {
  const MutexLock lock(mutex_);
  auto next = std::ranges::upper_bound(runs_, after, {}, &QueuedRun::id);
  List list;
  for (; next != runs_.end() && list.size() < most; ++next) list.push_back(queued_run_json(*next));
  Dict json{{"waiting", static_cast<std::int64_t>(count(QueuedStatus::waiting))}, {"runs", std::move(list)}};
  if (next != runs_.end()) json.set("next", std::prev(next)->id);
  if (!pause_) return json;
  Dict pause{{"reason", pause_->reason}};
  if (!pause_->run.empty()) pause.set("run", pause_->run);
  json.set("paused", std::move(pause));
  return json;
}

void RunQueue::forget_oldest() {
  const auto is_over = [](const QueuedRun& run) {
    return run.status != QueuedStatus::waiting && run.status != QueuedStatus::running;
  };
  while (static_cast<std::size_t>(std::ranges::count_if(runs_, is_over)) > kMostOver)
    runs_.erase(std::ranges::find_if(runs_, is_over));
}

void RunQueue::begin_next() {
  const auto next = take_next();
  if (!next || services::run_reporting("a queued run", [&] { begin(*next); })) return;
  refuse(*next, {{ErrorCode::unavailable, "the server failed to begin it; see its log", {}}});
}

void RunQueue::begin(const QueuedRun& run) {
  auto core = create_core(run.task);
  if (!core) return refuse(run, std::move(core).error());
  if (auto set = set_core(*core); !set) return give_up(run, *core, std::move(set).error());
  (*core)->start(
      [this, run, core = *core](const Expected<Value>& started) {
        pool_.post([this, run, core, started] { begun(run, core, started); });
      },
      Supervision{run.task.control, std::nullopt});
}

std::optional<QueuedRun> RunQueue::take_next() {
  const MutexLock lock(mutex_);
  if (closed_ || current_ != 0 || pause_) return std::nullopt;
  const auto next = std::ranges::find(runs_, QueuedStatus::waiting, &QueuedRun::status);
  if (next == runs_.end()) return std::nullopt;
  if (control_.stopped() || control_.stops() != stops_) {
    pause_ = Pause{"stopped"};
    return std::nullopt;
  }
  next->status = QueuedStatus::running;
  current_ = next->id;
  return *next;
}

Checked<std::shared_ptr<Core>> RunQueue::create_core(const QueuedTask& task) {
  const auto not_now = [](ErrorCode code, const char* why) {
    return tl::unexpected(std::vector<Error>{Error{code, why, {}}});
  };
  if (!records_.is_current(task.by)) return not_now(ErrorCode::rights, "who queued it is not known any more");
  if (has_lost_controls(task)) return not_now(ErrorCode::leased, kLostControls);
  const auto document = documents_.get(task.document, task.revision);
  if (!document) return tl::unexpected(document.error());
  return cores_.create(*document, task.arguments);
}

bool RunQueue::has_lost_controls(const QueuedTask& task) const {
  return task.control != 0 && control_.holder() != task.control;
}

// What has happened while the core was made.
Expected<void> RunQueue::set_core(const std::shared_ptr<Core>& core) {
  const MutexLock lock(mutex_);
  QueuedRun* run = current();
  if (!run || run->task.restores != restores_) return tl::unexpected(of_another_store());
  if (control_.stops() != stops_) return unexpected(ErrorCode::stopped, "the cell was stopped meanwhile");
  if (has_lost_controls(run->task)) return unexpected(ErrorCode::leased, kLostControls);
  run->core = core->id();
  core_ = core;
  return {};
}

// A core that is not `ready` has begun, whatever the answer: it keeps its place until it is over.
void RunQueue::begun(const QueuedRun& run, const std::shared_ptr<Core>& core, const Expected<Value>& started) {
  if (started || core->info().find("status")->as_string() != "ready") return record(run, "core " + core->id());
  give_up(run, core, started.error());
}

// Its core, which has not begun, goes.
void RunQueue::give_up(const QueuedRun& run, const std::shared_ptr<Core>& core, Error why) {
  refuse(run, {std::move(why)});
  cores_.remove(core->id(), [](const Expected<std::shared_ptr<Core>>&) {});
}

void RunQueue::refuse(const QueuedRun& run, std::vector<Error> errors) {
  record(run, std::string(name(errors.front().code)));
  std::shared_ptr<Core> dropped;  // after the lock
  const MutexLock lock(mutex_);
  QueuedRun* refused = current();
  if (!refused || refused->id != run.id) return;
  dropped = std::move(core_);
  refused->status = QueuedStatus::refused;
  refused->errors = std::move(errors);
  refused->core.clear();
  current_ = 0;
  pause_ = Pause{"refused", std::to_string(run.id)};
  forget_oldest();
}

void RunQueue::record(const QueuedRun& run, std::string outcome) {
  records_.record(run.task.by, "queue start " + std::to_string(run.id), std::move(outcome));
}

// One that is removed may have ended before, without that having been told.
void RunQueue::core_changed(const std::string& id, const Value& core) {
  std::shared_ptr<Core> dropped;  // after the lock
  const MutexLock lock(mutex_);
  QueuedRun* run = current();
  if (!run || !core_ || core_->id() != id) return;
  const Value last = core.is_null() ? core_->info() : core;
  const bool has_ended = is_over(last);
  if (!core.is_null() && !has_ended) return;
  dropped = std::move(core_);
  run->status = QueuedStatus::ended;
  run->end = has_ended ? last.find("status")->as_string() : "aborted";
  if (const Value* outcome = has_ended ? last.find("outcome") : nullptr) run->outcome = outcome->as_string();
  if (run->end == "aborted" || (run->end == "faulted" && !run->task.goes_on))
    pause_ = Pause{run->end, std::to_string(run->id)};
  current_ = 0;
  forget_oldest();
  post_next();
}

void RunQueue::cancel_all() {
  const MutexLock lock(mutex_);
  ++restores_;
  for (QueuedRun& run : runs_)
    if (run.status == QueuedStatus::waiting) run.status = QueuedStatus::cancelled;
  forget_oldest();
}

void RunQueue::close() {
  const MutexLock lock(mutex_);
  closed_ = true;
}

void RunQueue::end() {
  close();
  pool_.end();
}

}  // namespace race::server
