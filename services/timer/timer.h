// Timer: one alarm clock on the time of the group it lives in.
//
//   start(seconds)  deferred -> {"elapsed": seconds} when the time is over; `not_accepted` while it runs;
//                   error `cancelled`, or `invalid` at once if seconds is not a number in 0 .. 86400
//   cancel()        -> null; the start is answered `cancelled`; `not_accepted` while it does not run
//
// Events: `elapsed` {"seconds"} when a start comes to its end; `tick` {"time"} ten times a second [s], sampled.
//
// Threads: its group's.
#pragma once

#include "services/table_component.h"

namespace race::timer {

/// The RSM of every timer.
const rsm::Service& model();

class Timer final : public services::TableComponent {
 public:
  explicit Timer(services::ServiceHost& host);

  static const services::OperationTable& operations();
  void step() override;

 private:
  void start(const services::Call& call, const Dict& arguments);
  void cancel(const services::Call& call);
  void refuse_arguments(const services::Call& call, const Error& error) override;

  services::CallId running_ = 0;  // the start that waits; 0: none
  services::Time started_ = 0, seconds_ = 0, next_tick_ = 0;
};

}  // namespace race::timer
