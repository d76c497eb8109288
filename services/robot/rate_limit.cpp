#include "services/robot/rate_limit.h"

#include <algorithm>
#include <cmath>

#include "services/robot/path_follower.h"
#include "services/robot/planner.h"

namespace race::robot {
namespace {

constexpr std::size_t kIntervals = 400;  // between the places where the speed is looked at
// Of the change of the rate that braking allows: the follower takes its steps where it is, not where it gets to.
constexpr double kReserve = 0.8;

}  // namespace

RateLimit::RateLimit(const ArmModel& arm, const Trajectory& trajectory, const Joints& braking, double tool_speed)
    : spacing_(trajectory.duration() / kIntervals), squares_(kIntervals + 1) {
  std::vector<double> changes(kIntervals + 1);  // of the square from one place to the next, at most
  for (std::size_t i = 0; i <= kIntervals; ++i) {
    const Reference place = trajectory.at(static_cast<double>(i) * spacing_);
    const double planned = tool_way(arm, place.q, place.dq);
    const double most = planned > tool_speed ? tool_speed / planned : 1;
    squares_[i] = most * most;
    changes[i] = 2 * kReserve * steepest_rate(place, braking) * spacing_;
  }
  for (std::size_t i = kIntervals; i > 0; --i)
    squares_[i - 1] = std::min(squares_[i - 1], squares_[i] + std::min(changes[i - 1], changes[i]));
  for (std::size_t i = 0; i < kIntervals; ++i)
    squares_[i + 1] = std::min(squares_[i + 1], squares_[i] + std::min(changes[i], changes[i + 1]));
}

double RateLimit::at(double time) const {
  const double place = std::clamp(time / spacing_, 0.0, static_cast<double>(kIntervals));
  const auto before = std::min(static_cast<std::size_t>(place), kIntervals - 1);
  const double part = place - static_cast<double>(before);
  return std::sqrt((1 - part) * squares_[before] + part * squares_[before + 1]);
}

}  // namespace race::robot
