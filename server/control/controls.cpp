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
  if (auto refused = refuse_other(0)) return tl::unexpected(std::move(*refused));
  holder_ = Holder{++takings_, ++last_fence_, std::move(by), now, {}};
  tell();
  return holder_->number;
}

bool Control::hear(std::uint64_t number, Steady now) {
  const MutexLock lock(mutex_);
  if (!is_holder(number)) return false;
  holder_->heard = now;
  return true;
}

std::optional<Control::Ended> Control::release(std::uint64_t number) {
  const MutexLock lock(mutex_);
  if (!is_holder(number)) return std::nullopt;
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
  std::erase_if(reservations_, [&](const auto& each) { return each.second.core == by_hand; });
  holder_.reset();
  tell();
  return ended;
}

std::uint64_t Control::holder() const {
  const MutexLock lock(mutex_);
  return holder_ ? holder_->number : 0;
}

Expected<void> Control::check_holder(std::uint64_t number) const {
  if (is_holder(number)) return {};
  return unexpected(ErrorCode::leased, "take the controls of the cell first");
}

Expected<std::uint64_t> Control::fence_of(std::uint64_t number) const {
  const MutexLock lock(mutex_);
  if (auto holds = check_holder(number); !holds) return tl::unexpected(std::move(holds).error());
  return holder_->fence;
}

void Control::end_by_hand(const std::string& service, std::uint64_t call) {
  const MutexLock lock(mutex_);
  std::uint64_t& ended = ended_by_hand_[service];
  ended = std::max(ended, call);
}

void Control::show_request(std::optional<Request> request) {
  const MutexLock lock(mutex_);
  if (!request && !request_) return;
  request_ = std::move(request);
  tell();
}

Expected<Control::Ended> Control::set_mode(std::uint64_t number, Mode mode) {
  const MutexLock lock(mutex_);
  if (auto holds = check_holder(number); !holds) return tl::unexpected(std::move(holds).error());
  Ended ended{number, holder_->by, {}, {}};
  if (mode == mode_) return ended;
  for (const auto& [service, fence] : std::exchange(moved_, {})) ended.services.insert(service);
  for (const auto& [service, reservation] : reservations_)
    if (!is_person(reservation.core)) ended.cores.insert(reservation.core);
  ended.cores.merge(std::exchange(holder_->runs, {}));
  std::erase_if(reservations_, [](const auto& each) { return is_person(each.second.core); });
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

bool Control::confirms_edits(const std::string& core) {
  const MutexLock lock(mutex_);
  return mode_ == Mode::execution && (holder_ || has_accounts_()) && has_reserved(core);
}

bool Control::has_reserved(const std::string& core) const {
  return std::ranges::any_of(reservations_, [&](const auto& each) { return each.second.core == core; });
}

}  // namespace race::server
