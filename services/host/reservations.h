// Reservations: which answers are due, and when (ServiceHost::reserve). World time that can wait, waits here for the
// threads that prepare them; so a seed gives one run, however fast they are.
//
// Threads: any.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

#include "services/component.h"

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
  ReservationId reserve(std::size_t service, Time at);
  /// The answer is there; nothing happens if the reservation was dropped.
  void fulfil(ReservationId id, std::function<void()> answer);
  /// A service is gone: nobody waits for it.
  void drop(std::size_t service);
  /// Everything is gone, for good.
  void close();

  /// The answers that are there of those due at `now`, in the order (time, service, reservation). With `wait`, all of
  /// those due are: it waits for them.
  std::vector<Due> take(Time now, bool wait);

 private:
  struct Reservation {
    Due due;
    bool fulfilled = false;
  };
  bool all_fulfilled(Time now) const;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Reservation> open_;  // in order of id
  ReservationId next_ = 1;
  bool closed_ = false;
};

}  // namespace race::services
