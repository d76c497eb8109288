#include "services/timer/timer.h"

namespace race::timer {
namespace {

constexpr services::Time kTick = 0.1;
// Half a microsecond: sums of millisecond steps do not hit the end exactly.
constexpr services::Time kTolerance = 5e-7;

}  // namespace

Timer::Timer(services::ServiceHost& host) : TableComponent(operations(), host) {}

void Timer::start(const services::Call& call, const Dict& arguments) {
  running_ = call.id;
  started_ = host().now();
  seconds_ = arguments.find("seconds")->to_double();
}

void Timer::refuse_arguments(const services::Call& call, const Error& error) {
  refuse(call, services::error_value("invalid", error.message));
}

void Timer::cancel(const services::Call& call) {
  host().error(running_, services::error_value("cancelled", "the timer was cancelled"));
  running_ = 0;
  host().result(call.id, nullptr);
}

void Timer::wait(const services::Call& call, const Dict& arguments) {
  if (waits_.size() >= kMostWaits)
    return refuse(call, services::error_value("too_many", "at most " + std::to_string(kMostWaits) + " calls can wait"));
  const services::Time now = host().now();
  by_call_[call.id] = waits_.emplace(now + arguments.find("seconds")->to_double(), Wait{call.id, now});
}

void Timer::abandoned(services::CallId call) {
  const auto found = by_call_.find(call);
  if (found == by_call_.end()) return;
  end_wait(found->second);
  host().error(call, services::error_value("abandoned", "nobody waits for the response"));
}

// It has left its place, and may be answered.
Timer::Wait Timer::end_wait(Waits::iterator wait) {
  const Wait over = wait->second;
  by_call_.erase(over.call);
  waits_.erase(wait);
  take(running_ != 0 ? "waited_running" : "waited_idle", over.call);
  return over;
}

void Timer::answer_waits(services::Time now) {
  while (!waits_.empty() && waits_.begin()->first <= now + kTolerance) {
    const Wait over = end_wait(waits_.begin());
    host().result(over.call, Dict{{"elapsed", Value(now - over.began)}});
  }
}

void Timer::step() {
  const services::Time now = host().now();
  answer_waits(now);
  if (running_ != 0 && now - started_ >= seconds_ - kTolerance) {
    take("elapse");
    host().result(running_, Dict{{"elapsed", Value(now - started_)}});
    host().event("elapsed", Dict{{"seconds", Value(seconds_)}});
    running_ = 0;
  }
  if (now >= next_tick_ - kTolerance) {
    host().event("tick", Dict{{"time", Value(now)}});
    next_tick_ = next_tick_ + kTick > now ? next_tick_ + kTick : now + kTick;
  }
}

}  // namespace race::timer
