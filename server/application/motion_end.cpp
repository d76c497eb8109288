#include "server/application/motion_end.h"

#include <algorithm>
#include <thread>

#include "server/execution/cores.h"
#include "services/failures.h"
#include "services/host/host.h"

namespace race::server {
namespace {

using services::ServiceStatus;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr const char* kEnds = "the server ends";
constexpr milliseconds kLook{2};  // between two looks at what services say

bool can_stop(const ServiceStatus& service) {
  return service.available && std::ranges::any_of(service.model->operations, &rsm::Operation::safe);
}

// A call of an operation that sets something in motion is not answered yet.
bool awaits_motion(const ServiceStatus& service) {
  return std::ranges::any_of(service.pending, [&](const services::PendingCall& call) {
    return std::ranges::any_of(service.model->operations, [&](const rsm::Operation& operation) {
      return operation.moves && operation.name == call.operation;
    });
  });
}

}  // namespace

// The cores stop first: no answer of what follows may lead a run anywhere.
void MotionEnd::begin_end(services::Host& host, Cores& cores, std::function<void()> done) {
  ended_ = true;
  pool_.post([this, &host, &cores, done = std::move(done)] {
    services::run_reporting("the end of the cell", [&] {
      cores.close();
      const bool moves = is_moving(host);
      host.call_safe();
      await_stand(host, moves);
    });
    done();
  });
}

bool MotionEnd::is_moving(const services::Host& host) const {
  return steady_clock::now() < last_motion_.load() + kLastMotion || std::ranges::any_of(host.services(), awaits_motion);
}

void MotionEnd::finish() {
  given_up_ = true;
  pool_.end();
}

void MotionEnd::await_stand(const services::Host& host, bool is_moving) const {
  const auto wait = [&](milliseconds time, auto&& is_over) {
    const auto end = steady_clock::now() + time;
    while (!given_up_ && !is_over() && steady_clock::now() < end) std::this_thread::sleep_for(kLook);
  };
  if (std::ranges::any_of(host.services(), can_stop)) wait(kArrival, [] { return false; });
  wait(kAnswerTimeout, [&] {
    return std::ranges::none_of(
        host.services(), [](const ServiceStatus& service) { return can_stop(service) && service.pending_count > 0; });
  });
  if (is_moving) wait(kBraking, [] { return false; });
}

Expected<std::uint64_t> MotionEnd::begin(const services::Beginning& run) {
  if (ended_) return unexpected(ErrorCode::unavailable, kEnds);
  return gate_.begin(run);
}

std::optional<Value> MotionEnd::refuse(const services::Caller& caller, const std::string& service,
                                       rsm::CallEffect effect) {
  if (ended_) return Value(Dict{{"code", name(ErrorCode::stopped)}, {"message", kEnds}});
  auto refused = gate_.refuse(caller, service, effect);
  if (!refused && effect == rsm::CallEffect::motion) last_motion_ = steady_clock::now();
  return refused;
}

}  // namespace race::server
