// Turns of a core on its strand: what waits is taken, micro steps are done, and the rest waits until the others had
// theirs.
#include <algorithm>
#include <chrono>
#include <utility>

#include "server/execution/core.h"
#include "services/computed_time.h"

namespace race::server {

using execution::Progress;

namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

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
  if (is_busy()) return strand_.post_later(std::move(turn));
  strand_.post(std::move(turn));
}

// Work that may throw.
Work Core::measured(Work work) {
  return interrupting([this, work = std::move(work)] {
    const Measurement measurement(computing_);
    work();
  });
}

// One turn: as many micro steps as are its due, then the others on this pool. Too far ahead of the disk, it is left
// until that has caught up (durable()). A thread that had to wait for its processor has not used up the turn.
void Core::advance() {
  if (!take_inbox()) return;
  if (!started_ || paused_ || closed_ || is_over()) return;
  const auto end = services::thread_time() + kTurnTime;
  for (std::uint32_t left = kTurn; left > 0 && services::thread_time() < end;) {
    if (held_.is_full()) return;
    if (!execution_.is_open() && hold_asked_.exchange(false)) return hold();
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
  for (std::size_t i = 0; i < inbox.deliveries.size(); ++i) {
    services::Delivery& delivery = inbox.deliveries[i];
    if (!has_room()) {
      has_dropped = true;
      break;
    }
    const std::size_t units = delivery.units;
    waiting_units_ += units;
    received_units_ += units;
    const bool waits =
        delivery.kind == services::Delivery::Kind::event
            ? execution_.post_event(delivery.key, delivery.name, std::move(delivery.data))
            : execution_.post_response(delivery.caller.call, delivery.is_error, std::move(delivery.data));
    if (waits) timing_.arrived(execution_, inbox.times[i]);
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
  const auto computed = services::thread_time();
  const bool begins = !execution_.is_open();
  if (begins) step_time_ = {};
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(resources_.longest_step - step_time_);
  const Progress* progress = nullptr;
  {
    const auto watch = resources_.watchdog.watch(give_up_, left);
    progress = &next_part(std::min(limit, part_));
  }
  part_ = services::thread_time() - computed > kTurnTime / 4 ? 1 : std::min(2 * part_, kPart);
  step_time_ += Clock::now() - begin;
  if (begins) timing_.began(execution_, progress->entry, begin);
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
  if (!reached_breakpoints_.empty()) reached_breakpoints_.clear();
  for (const std::uint32_t number : progress.breakpoints) reached_breakpoints_.push_back(static_cast<int>(number));
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
  give_up_macro_step(kDeadline,
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

}  // namespace race::server
