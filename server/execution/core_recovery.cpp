// Interruptions: a run is rebuilt from its journal, after the server ended under it or when the disk fails.
#include <tuple>
#include <utility>

#include "server/execution/core_internal.h"
#include "services/failures.h"

namespace race::server {

using execution::Execution;

Expected<std::shared_ptr<Core>> Core::recover(RunRecord run, execution::JournalHeader header,
                                              const CoreResources& resources) {
  ASSIGN_OR_RETURN(auto core, create(std::move(run), std::move(header), resources));
  core->paused_ = true;
  core->interruption_ = {.number = 0, .reason = "restart", .message = "the server ended while the run was under way"};
  auto rebuilt = core->rebuild(kRebuildAtStart);
  if (rebuilt)
    core->take(std::move(*rebuilt));
  else if (rebuilt.error().code != ErrorCode::unavailable)
    return tl::unexpected(std::move(rebuilt).error());
  core->ends_later_ = !rebuilt;
  core->started_ = core->started_ || !rebuilt;
  {
    const services::MutexLock lock(core->mutex_);
    core->info_ = core->info_json();
  }
  if (core->is_over()) core->strand_.post([core] { core->end_rebuilt_run(); });
  if (!rebuilt) core->rebuild_later();
  return core;
}

// Where its journal is written, and who hears of it.
void Core::open_journal() {
  const std::shared_ptr<RunSink> sink(shared_from_this(), this);
  journal_ = std::make_shared<RunJournal>(record_, sink);
}

void Core::durable(std::uint64_t ticket) {
  strand_.post(measured([this, ticket] {
    held_.set_durable(ticket);
    timing_.durable(ticket);
    if (!saying_ || held_.has_answers()) say_due();
  }));
}

// The run stands still until failed().
void Core::stalled(const Error& error) {
  strand_.post([self = shared_from_this(), error] {
    self->interrupt(error);
    self->interruption_->stalled = true;
  });
}

void Core::failed(const Error& error) {
  strand_.post([self = shared_from_this(), error] {
    const bool was_stalled = self->interruption_ && std::exchange(self->interruption_->stalled, false);
    if (!was_stalled) self->interrupt(error);
    self->rebuild_later();
  });
}

// core/SEMANTICS.md section 10. What it was about to say is never said. What it has set in motion is told to stop, by
// nobody's call: no answer to these reaches a run, and none to its open calls, which are `unavailable` to it
// (rebuild()).
void Core::interrupt(const Error& error, const char* reason) {
  interruption_ = {.number = ++interruptions_,
                   .reason = reason,
                   .message = error.message,
                   .was_paused = std::exchange(paused_, true)};
  ends_later_ = is_stopped_ || interruption_->reason == kOverload || interruption_->reason == kDeadline;
  make_safe_calls(run().safe_calls());
  services::run_reporting("the calls of a run", [this] { resources_.host.abandon_all(id_); });
  execution_.set_goal(std::nullopt);
  services::run_reporting("an interruption", [this] { publish_interruption(); });
  held_.fail(error);
}

// Nobody's calls: no answer to them reaches a run.
void Core::make_safe_calls(const std::vector<semantics::OutgoingCall>& calls) const {
  services::run_reporting("the safe calls of a run", [&] {
    for (const semantics::OutgoingCall& call : calls)
      resources_.host.call({"", 0}, call.service, call.name, {}, {}, id_);
  });
}

void Core::interrupt_after(const std::exception& failure) {
  if (interruption_) return;
  interrupt_and_rebuild({ErrorCode::unavailable, std::string("a step failed: ") + failure.what(), {}}, "failure");
}

void Core::interrupt_and_rebuild(const Error& error, const char* reason) {
  interrupt(error, reason);
  interruption_->stalled = true;  // until what it has handed over is stored
  resources_.writer.append(journal_, {.failure = error});
}

Work Core::interrupting(Work work) {
  return [self = shared_from_this(), work = std::move(work)] {
    try {
      work();
    } catch (const std::exception& failure) {
      self->interrupt_after(failure);
      throw;  // for the log
    }
  };
}

// Not on the strand: the threads of the cores never wait for the disk, so that the safe calls of all are made at once.
void Core::rebuild_later() {
  interruption_->rebuilding = true;
  resources_.writer.recover([self = shared_from_this(), number = interruption_->number] {
    self->strand_.post([self, number, rebuilt = std::make_shared<Expected<Rebuilt>>(self->rebuild(kLongestRebuild))] {
      self->take_rebuilt(number, std::move(*rebuilt));
    });
  });
}

void Core::take_rebuilt(std::uint64_t interruption, Expected<Rebuilt> rebuilt) {
  if (!is_to_rebuild() || interruption_->number != interruption) return;
  interruption_->rebuilding = false;
  if (!rebuilt) {
    ends_later_ = rebuilt.error().code == ErrorCode::unavailable;
    if (ends_later_ && is_stopped_ && !server_ends_) return rebuild_later();
    interruption_->message += "; " + rebuilt.error().message;
    return publish_interruption();
  }
  ends_later_ = false;
  const bool was_paused = interruption_->was_paused, is_stopped = is_stopped_.exchange(false);
  make_safe_calls(rebuilt->safe_calls);
  take(std::move(*rebuilt));
  if (!started_) paused_ = was_paused;
  if (!is_stopped) return publish_info();
  started_ = true;  // also a run whose first macro step was given up: `abort` is its first entry then
  std::ignore = end_run_now();
  publish_info();
}

void Core::ensure_rebuilt(Done<void> done) {
  if (info().find("status")->as_string() != "interrupted") return done({});
  using Number = std::optional<std::uint64_t>;
  Done<Number> found = [self = shared_from_this(), done = std::move(done)](const Expected<Number>& interruption) {
    if (!interruption) return done(tl::unexpected(interruption.error()));
    if (!*interruption) return done({});
    self->rebuild_for(**interruption, done);
  };
  on_strand<Number>(std::move(found), [this]() -> Expected<Number> {
    return is_to_rebuild() ? Number(interruption_->number) : std::nullopt;
  });
}

// The disk may keep the thread of recovery for long: who asked is answered all the same, and nothing more happens.
void Core::rebuild_for(std::uint64_t interruption, Done<void> done) {
  auto once = std::make_shared<Once<void>>(std::move(done));
  resources_.deadlines.after(2 * DiskWatch::kTimeout, [weak = std::weak_ptr(once)] {
    if (const auto late = weak.lock())
      (*late)(unexpected(ErrorCode::unavailable, "the run takes long to be read back; ask again"));
  });
  resources_.writer.recover([self = shared_from_this(), interruption, once = std::move(once)] {
    if (once->was_called()) return;
    auto rebuilt = std::make_shared<Expected<Rebuilt>>(self->rebuild(kLongestRebuild));
    if (!*rebuilt) return (*once)(tl::unexpected(rebuilt->error()));
    Done<bool> taken = [once](const Expected<bool>& is_taken) {
      (*once)(is_taken ? Expected<void>() : tl::unexpected(is_taken.error()));
    };
    self->on_strand<bool>(std::move(taken), [raw = self.get(), interruption, rebuilt]() -> Expected<bool> {
      raw->take_rebuilt(interruption, std::move(*rebuilt));
      return true;
    });
  });
}

// As it was known last: what was computed since is in no journal.
void Core::publish_interruption() {
  Dict info = this->info().as_dict();
  info.set("status", "interrupted");
  info.set("interruption", Dict{{"reason", interruption_->reason}, {"message", interruption_->message}});
  info.set("paused", true);
  Value frozen = std::move(info);
  if (auto sound = readable(); !sound) set_reached(tl::unexpected(std::move(sound).error()));
  set_info(std::move(frozen.freeze()));
}

// The journal has its last entry, but not that it is the last.
void Core::end_rebuilt_run() {
  interruption_.reset();
  const std::uint64_t ticket = held_.next_ticket();
  timing_.ended(execution_);
  resources_.writer.append(journal_,
                           {.ticket = ticket, .end = run_end(), .timing = timing_.take_block(execution_, ticket)});
  publish_info();
}

/// Error `storage`: the run cannot be read, and what is in memory is not in its journal.
Expected<void> Core::readable() const {
  if (interruption_ && !interruption_->rebuilt) return unexpected(ErrorCode::storage, interruption_->message);
  return {};
}

// The run as its journal says. Its open calls are answered `unavailable` (R7) and never sent again; what had arrived
// before is forgotten.
Expected<Core::Rebuilt> Core::rebuild(std::chrono::milliseconds longest) const {
  ASSIGN_OR_RETURN(RunRecord stored, resources_.runs.get(run_id()));
  execution::Replay replay(header_, resources_.runs.source(run_id()));
  *end_rebuild_ = *end_last_step_ = false;
  if (server_ends_) return unexpected(ErrorCode::unavailable, "the server ends");
  const auto begin = std::chrono::steady_clock::now();
  const auto watch = resources_.watchdog.watch(end_rebuild_, longest);
  auto before = replay.after(stored.steps > 0 ? stored.steps - 1 : 0, end_rebuild_.get());
  if (!before) return tl::unexpected(as_timed_out(std::move(before).error()));
  if (stored.steps == 0) return rebuilt_from(std::move(stored), *std::move(before));
  const auto used = std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begin);
  return rebuild_last_step(replay, std::move(stored), *std::move(before), longest - used);
}

// It may have been the reason of the interruption, so it may take long. One that is stopped meanwhile is aborted in it,
// without an entry (core/SEMANTICS.md section 10): what is known of it is what was before.
Expected<Core::Rebuilt> Core::rebuild_last_step(execution::Replay& replay, RunRecord stored, Execution before,
                                                std::chrono::milliseconds longest) const {
  const bool is_stopped = is_stopped_;
  if (is_stopped && !server_ends_) *end_last_step_ = false;  // it has its time
  const auto watch = resources_.watchdog.watch(end_last_step_, is_stopped ? std::min(longest, kWaitForStep) : longest);
  auto last = replay.next(before, end_last_step_.get());
  if (last) return rebuilt_from(std::move(stored), *std::move(last));
  if (last.error().code != ErrorCode::unavailable || !is_stopped_ || server_ends_)
    return tl::unexpected(as_timed_out(std::move(last).error()));
  before.stop_with(give_up_.get());
  std::vector<semantics::OutgoingCall> safe_calls = before.run().safe_calls();
  before.abort();
  return Rebuilt{std::move(stored), std::move(before), std::move(safe_calls)};
}

Core::Rebuilt Core::rebuilt_from(RunRecord stored, Execution rebuilt) const {
  rebuilt.stop_with(give_up_.get());
  rebuilt.post_lost();
  // A disk that takes nothing leaves it as `running`: when the server has ended, that means the same.
  if (stored.steps > 0 && !rebuilt.is_over()) std::ignore = resources_.runs.set_status(run_id(), "interrupted");
  return {std::move(stored), std::move(rebuilt), {}};
}

Error Core::as_timed_out(Error error) {
  if (error.code == ErrorCode::unavailable) error.message = "the run takes too long to be rebuilt from its journal";
  return error;
}

// One that had not begun waits to be started.
void Core::take(Rebuilt rebuilt) {
  execution_ = std::move(rebuilt.execution);
  *give_up_ = false;
  record_ = std::move(rebuilt.record);
  revision_ = std::max(record_.revision, execution_.model().revision);
  model_since_ = execution_.is_edited() ? run().position() : 0;
  set_model(execution_.model());
  set_reached(reached_now());
  find_breakpoints();
  timing_.rebuilt(execution_);
  note_services();
  open_journal();
  started_ = record_.steps > 0;
  interruption_->rebuilt = true;
  if (!started_ || record_.is_over()) interruption_.reset();  // the disk that hung may have taken its end
  if (state_watched_) publish_snapshot(&CoreWatcher::state_snapshot);
  if (derivation_watched_) publish_next_derivation();
  follow_again();
}

}  // namespace race::server
