// The person at the controls, and the modes.
#include <algorithm>
#include <utility>

#include "server/control/control.h"

namespace race::server {

using services::MutexLock;

std::string_view name(Mode mode) { return mode == Mode::programming ? "programming" : "execution"; }

std::optional<Mode> mode_of(std::string_view name) {
  for (const Mode mode : {Mode::execution, Mode::programming})
    if (race::server::name(mode) == name) return mode;
  return std::nullopt;
}

Expected<std::uint64_t> Control::take(std::string by, Steady now) {
  const MutexLock lock(mutex_);
  if (holder_) return unexpected(ErrorCode::leased, holder_->by + " has the controls of the cell");
  holder_ = Holder{++takings_, ++last_fence_, std::move(by), now, {}};
  tell();
  return holder_->number;
}

bool Control::hear(std::uint64_t number, Steady now) {
  const MutexLock lock(mutex_);
  if (!holder_ || holder_->number != number) return false;
  holder_->heard = now;
  return true;
}

std::optional<Control::Ended> Control::release(std::uint64_t number) {
  const MutexLock lock(mutex_);
  if (!holder_ || holder_->number != number) return std::nullopt;
  return end_holder();
}

std::optional<Control::Ended> Control::release_silent(Steady now) {
  const MutexLock lock(mutex_);
  if (!holder_ || now - holder_->heard <= kSilence) return std::nullopt;
  return end_holder();
}

// What runs that needed them have reserved stays theirs: they can go on when somebody else has the controls. A motion
// may go on without a reservation: of a run that is over.
Control::Ended Control::end_holder() {
  Ended ended{holder_->number, holder_->by, {}, std::move(holder_->runs)};
  const std::string by_hand = caller(holder_->number);
  for (const auto& [service, fence] : moved_)
    if (fence == holder_->fence) ended.services.insert(service);
  std::erase_if(leases_, [&](const auto& lease) { return lease.second.core == by_hand; });
  holder_.reset();
  tell();
  return ended;
}

std::uint64_t Control::holder() const {
  const MutexLock lock(mutex_);
  return holder_ ? holder_->number : 0;
}

Expected<std::uint64_t> Control::fence_of(std::uint64_t number) const {
  const MutexLock lock(mutex_);
  if (!holder_ || holder_->number != number)
    return unexpected(ErrorCode::leased, "take the controls of the cell first");
  return holder_->fence;
}

void Control::show_request(std::optional<Request> request) {
  const MutexLock lock(mutex_);
  if (!request && !request_) return;
  request_ = std::move(request);
  tell();
}

Expected<Control::Ended> Control::set_mode(std::uint64_t number, Mode mode) {
  const MutexLock lock(mutex_);
  if (!holder_ || holder_->number != number)
    return unexpected(ErrorCode::leased, "take the controls of the cell first");
  Ended ended{number, holder_->by, {}, {}};
  if (mode == mode_) return ended;
  for (const auto& [service, fence] : std::exchange(moved_, {})) ended.services.insert(service);
  for (const auto& [service, lease] : leases_)
    if (!is_person(lease.core)) ended.cores.insert(lease.core);
  ended.cores.merge(std::exchange(holder_->runs, {}));
  std::erase_if(leases_, [](const auto& lease) { return is_person(lease.second.core); });
  free_fence_ = ++last_fence_;
  holder_->fence = ++last_fence_;
  mode_ = mode;
  tell();
  return ended;
}

void Control::set_mode(Mode mode) {
  const MutexLock lock(mutex_);
  mode_ = mode;
}

Mode Control::mode() const {
  const MutexLock lock(mutex_);
  return mode_;
}

void Control::confirm_all_edits(bool on) {
  const MutexLock lock(mutex_);
  confirms_all_edits_ = on;
}

bool Control::confirms_edits(const std::string& core) {
  const MutexLock lock(mutex_);
  return mode_ == Mode::execution && (holder_ || confirms_all_edits_) && has_reserved(core);
}

bool Control::has_reserved(const std::string& core) const {
  return std::ranges::any_of(leases_, [&](const auto& lease) { return lease.second.core == core; });
}

}  // namespace race::server
