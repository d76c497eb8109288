#include "services/timer/timer.h"
#include "services/types.h"

namespace race::timer {

namespace types = services::types;

const services::OperationTable& Timer::operations() {
  static const services::OperationTable table({
      .name = "timer",
      .operations =
          {
              {.name = "start",
               .handler = &Timer::start,
               .parameters = {{.name = "seconds", .type = "number", .unit = "s", .min = 0, .max = 86400}},
               .result = types::record({{"elapsed", "number"}}),
               .error = types::record({{"code", "string"}, {"message", "string"}}),
               .doc = "Answers when the time is over."},
              {.name = "wait",
               .handler = &Timer::wait,
               .parameters = {{.name = "seconds", .type = "number", .unit = "s", .min = 0, .max = 86400}},
               .result = types::record({{"elapsed", "number"}}),
               .error = types::record({{"code", "string"}, {"message", "string"}}),
               .doc = "Answers when the time is over, each call by itself, also while the alarm runs."},
              {.name = "cancel",
               .handler = &Timer::cancel,
               .doc = "Ends a start, which is answered with the error `cancelled`."},
          },
      .events =
          {
              {.name = "elapsed",
               .data = types::record({{"seconds", "number"}}),
               .doc = "A start has come to its end."},
              {.name = "tick",
               .data = types::record({{"time", "number"}}),
               .sampled = true,
               .rate_hz = 10,
               .doc = "The time [s]."},
          },
      .states = {{"Idle", {"tick"}}, {"Running", {"tick"}}},
      .init = "Idle",
      .transitions =
          {
              {.id = "start",
               .src = "Idle",
               .dst = "Running",
               .operation = "start",
               .defer = {"elapse", "cancel", "refuse"},
               .refused = "refuse"},
              {.id = "elapse", .src = "Running", .dst = "Idle", .events = {"elapsed"}},
              {.id = "cancel", .src = "Running", .dst = "Idle", .operation = "cancel", .error = "cancelled"},
              {.id = "refuse", .src = "Running", .dst = "Idle", .error = "invalid"},
              {.id = "wait_idle",
               .src = "Idle",
               .dst = "Idle",
               .operation = "wait",
               .defer = {"waited_idle", "waited_running"},
               .concurrent = true,
               .refused = "waited_idle"},
              {.id = "wait_running",
               .src = "Running",
               .dst = "Running",
               .operation = "wait",
               .defer = {"waited_idle", "waited_running"},
               .concurrent = true,
               .refused = "waited_running"},
              {.id = "waited_idle", .src = "Idle", .dst = "Idle"},
              {.id = "waited_running", .src = "Running", .dst = "Running"},
          },
  });
  return table;
}

const rsm::Service& model() { return Timer::operations().model(); }

}  // namespace race::timer
