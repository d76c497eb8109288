// Timer: on the time of the group it lives in, one alarm clock, and waits, up to kMostWaits at a time.
//
//   wait(seconds)   deferred -> {"elapsed": seconds} when the time is over, each call by itself, in every state;
//                   `invalid` as start; `too_many` at once if kMostWaits wait; `abandoned` at once when nobody can
//                   receive the response any more, which frees its place
//   start(seconds)  deferred -> {"elapsed": seconds} when the time is over; `not_accepted` while it runs;
//                   error `cancelled`, or `invalid` at once if seconds is not a number in 0 .. 86400
//   cancel()        -> null; the start is answered `cancelled`; `not_accepted` while it does not run
//
// Events: `elapsed` {"seconds"} when a start comes to its end; `tick` {"time"} ten times a second [s], sampled.
//
// Threads: its group's.
#pragma once

#include <map>

#include "services/table_component.h"

namespace race::timer {

/// The RSM of every timer.
const rsm::Service& model();

class Timer final : public services::TableComponent {
 public:
  explicit Timer(services::ServiceHost& host);

  static constexpr std::size_t kMostWaits = 1000;

  static const services::OperationTable& operations();
  /// Ends a wait. The alarm rings on: its event is for all cores.
  void abandoned(services::CallId call) override;
  void step() override;

 private:
  struct Wait {
    services::CallId call = 0;
    services::Time began = 0;
  };
  using Waits = std::multimap<services::Time, Wait>;
  Wait end_wait(Waits::iterator wait);
  void wait(const services::Call& call, const Dict& arguments);
  void answer_waits(services::Time now);
  void start(const services::Call& call, const Dict& arguments);
  void cancel(const services::Call& call);
  void refuse_arguments(const services::Call& call, const Error& error) override;

  Waits waits_;                                          // by their ends; of equal ones the earlier first
  std::map<services::CallId, Waits::iterator> by_call_;  // the same
  services::CallId running_ = 0;                         // the start that waits; 0: none
  services::Time started_ = 0, seconds_ = 0, next_tick_ = 0;
};

}  // namespace race::timer
