#include "services/timer/timer.h"

#include "core/rsm/document.h"
#include "services/arguments.h"

namespace race::timer {
namespace {

constexpr services::Time kTick = 0.1;

constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "timer",
  "operations": [
    {"name": "start", "parameters": [{"name": "seconds", "type": "number", "unit": "s", "min": 0, "max": 86400}],
     "result": {"record": {"elapsed": "number"}}, "error": {"record": {"code": "string", "message": "string"}},
     "doc": "Answers when the time is over."},
    {"name": "cancel", "doc": "Ends a start, which is answered with the error `cancelled`."}
  ],
  "events": [
    {"name": "elapsed", "data": {"record": {"seconds": "number"}}, "doc": "A start has come to its end."},
    {"name": "tick", "data": {"record": {"time": "number"}}, "sampled": true, "rate_hz": 10, "doc": "The time [s]."}
  ],
  "states": [{"name": "Idle", "events": ["tick"]}, {"name": "Running", "events": ["tick"]}], "init": "Idle",
  "transitions": [
    {"id": "start", "src": "Idle", "dst": "Running", "operation": "start", "defer": ["elapse", "cancel", "refuse"]},
    {"id": "elapse", "src": "Running", "dst": "Idle", "events": ["elapsed"]},
    {"id": "cancel", "src": "Running", "dst": "Idle", "operation": "cancel", "error": "cancelled"},
    {"id": "refuse", "src": "Running", "dst": "Idle", "error": "invalid"}
  ]
})json";

}  // namespace

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(kModel, "services/timer").value();
  return service;
}

Timer::Timer(services::ServiceHost& host) : host_(host) {}

void Timer::call(const services::Call& call) {
  if (call.operation == "start" && running_ == 0) {
    start(call);
  } else if (call.operation == "cancel" && running_ != 0) {
    cancel(call);
  } else {
    host_.reject(call.id);
  }
}

void Timer::start(const services::Call& call) {
  host_.transition("start", call.id);
  const auto arguments = services::bind_arguments(*services::find_operation(model(), "start"), call);
  if (!arguments) {
    host_.transition("refuse");
    host_.error(call.id, services::error_value("invalid", arguments.error().message));
    return;
  }
  running_ = call.id;
  started_ = host_.now();
  seconds_ = arguments->find("seconds")->to_double();
}

void Timer::cancel(const services::Call& call) {
  host_.transition("cancel", call.id);
  host_.error(running_, services::error_value("cancelled", "the timer was cancelled"));
  running_ = 0;
  host_.result(call.id, nullptr);
}

void Timer::step() {
  const services::Time now = host_.now();
  // Half a microsecond: sums of millisecond steps do not hit the end exactly.
  constexpr services::Time kTolerance = 5e-7;
  if (running_ != 0 && now - started_ >= seconds_ - kTolerance) {
    host_.transition("elapse");
    host_.result(running_, Dict{{"elapsed", Value(now - started_)}});
    host_.event("elapsed", Dict{{"seconds", Value(seconds_)}});
    running_ = 0;
  }
  if (now >= next_tick_ - kTolerance) {
    host_.event("tick", Dict{{"time", Value(now)}});
    next_tick_ = next_tick_ + kTick > now ? next_tick_ + kTick : now + kTick;
  }
}

}  // namespace race::timer
