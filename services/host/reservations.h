// Reservations: which answers are due, and when (ServiceHost::reserve). World time that can wait, waits here for the
// threads that prepare them; so a seed gives one run, however fast they are.
//
// Threads: any.
#pragma once

#include <functional>
#include <vector>

#include "services/component.h"
#include "services/mutex.h"

namespace race::services {

class Reservations {
 public:
  /// What is to run now, of which service.
  struct Due {
    Time at = 0;
    std::size_t service = 0;  // number of the service in order of declaration
    ReservationId id = 0;
    std::function<void()> answer;
  };

  /// Announces an answer of `service` as of `at`.
  ReservationId reserve(std::size_t service, Time at) EXCLUDES(mutex_);
  /// The answer is there; nothing happens if the reservation was dropped.
  void fulfil(ReservationId id, std::function<void()> answer) EXCLUDES(mutex_);
  /// A service is disconnected: removes its reservations.
  void drop(std::size_t service) EXCLUDES(mutex_);
  /// Removes all reservations, and takes none any more.
  void close() EXCLUDES(mutex_);

  /// The answers that are there of those due at `now`, in the order (time, service, reservation). With `wait`, all of
  /// those due are: it waits for them.
  std::vector<Due> take(Time now, bool wait) EXCLUDES(mutex_);

 private:
  struct Reservation {
    Due due;
    bool fulfilled = false;
  };
  bool all_fulfilled(Time now) const REQUIRES(mutex_);

  Mutex mutex_;
  ConditionVariable changed_;
  std::vector<Reservation> open_ GUARDED_BY(mutex_);  // in order of id
  ReservationId next_ GUARDED_BY(mutex_) = 1;
  bool closed_ GUARDED_BY(mutex_) = false;
};

}  // namespace race::services
