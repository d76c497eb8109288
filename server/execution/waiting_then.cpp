#include "server/execution/waiting_then.h"

#include <algorithm>
#include <utility>

namespace race::server {

// Inputs are delivered in order of arrival, so that all that waited then was delivered or dropped when the first one is
// delivered that came later, or before `until`.
bool WaitingThen::take(const TimingBlock& block) {
  if (known_ || lost_) return false;
  lost_ = block.first > next_;  // what one of the macro steps between has delivered is not known
  for (const Undelivered& each : block.undelivered)
    if (waited(each.arrival) && moment_ < each.dropped) add(each.arrival, {.undelivered = each.input});
  for (std::size_t i = 0; i < block.steps.size(); ++i) {
    const std::uint64_t number = block.first + i;
    if (number < next_) continue;
    next_ = number + 1;
    const std::optional<Arrival>& input = block.steps[i].input;
    if (!input) continue;
    if (waited(*input))
      add(*input, {.step = number});
    else
      known_ = block.since <= moment_;
  }
  known_ = known_ || (block.since <= moment_ && moment_ < block.until);
  lost_ = lost_ || (!known_ && block.since > moment_);
  return !known_ && !lost_;
}

void WaitingThen::add(const Arrival& arrival, WaitedInput input) {
  input.time = arrival.time;
  found_.push_back({arrival, std::move(input)});
}

std::optional<std::vector<WaitedInput>> WaitingThen::inputs() const {
  if (!known_ || lost_) return std::nullopt;
  std::vector<Found> found = found_;
  std::ranges::stable_sort(found, {},
                           [](const Found& each) { return std::pair(each.arrival.moment, each.arrival.time); });
  std::vector<WaitedInput> inputs;
  for (Found& each : found) inputs.push_back(std::move(each.input));
  return inputs;
}

}  // namespace race::server
