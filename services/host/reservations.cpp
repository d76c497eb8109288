#include "services/host/reservations.h"

#include <algorithm>
#include <tuple>

namespace race::services {
namespace {

// Half a microsecond: sums of millisecond steps do not hit a time exactly.
constexpr Time kTolerance = 5e-7;

bool is_due(const Reservations::Due& due, Time now) { return due.at <= now + kTolerance; }

}  // namespace

ReservationId Reservations::reserve(std::size_t service, Time at) {
  const MutexLock lock(mutex_);
  const ReservationId id = next_++;
  if (!closed_) open_.push_back({{at, service, id, {}}});
  return id;
}

void Reservations::fulfil(ReservationId id, std::function<void()> answer) {
  {
    const MutexLock lock(mutex_);
    const auto found = std::ranges::find(open_, id, [](const Reservation& each) { return each.due.id; });
    if (found == open_.end()) return;
    if (answer) {
      found->due.answer = std::move(answer);
      found->fulfilled = true;
    } else {
      open_.erase(found);
    }
  }
  changed_.notify_all();
}

void Reservations::drop(std::size_t service) {
  {
    const MutexLock lock(mutex_);
    std::erase_if(open_, [&](const Reservation& each) { return each.due.service == service; });
  }
  changed_.notify_all();
}

void Reservations::close() {
  {
    const MutexLock lock(mutex_);
    open_.clear();
    closed_ = true;
  }
  changed_.notify_all();
}

bool Reservations::all_fulfilled(Time now) const {
  return std::ranges::all_of(open_, [&](const Reservation& each) { return each.fulfilled || !is_due(each.due, now); });
}

std::vector<Reservations::Due> Reservations::take(Time now, bool wait) {
  std::vector<Due> taken;
  const MutexLock lock(mutex_);
  if (wait) changed_.wait(mutex_, [&]() REQUIRES(mutex_) { return all_fulfilled(now); });
  std::erase_if(open_, [&](Reservation& each) {
    if (!each.fulfilled || !is_due(each.due, now)) return false;
    taken.push_back(std::move(each.due));
    return true;
  });
  std::ranges::sort(taken, {}, [](const Due& due) { return std::tuple(due.at, due.service, due.id); });
  return taken;
}

}  // namespace race::services
