#include "services/robot/path_follower.h"

#include <algorithm>
#include <cmath>

namespace race::robot {
namespace {

constexpr double kFastest = 20;  // 1/s, change of the rate where the path is slow

}  // namespace

double steepest_rate(const Reference& place, const Joints& braking) {
  double slope = kFastest;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (std::abs(place.dq[i]) > 1e-9) slope = std::min(slope, braking[i] / std::abs(place.dq[i]));
  }
  return slope;
}

Reference PathFollower::advance(double rate, double dt) {
  Reference reference = trajectory_.at(time_);
  const double most = steepest_rate(reference, braking_) * dt;
  const double change = at_start() ? rate - rate_ : std::clamp(rate - rate_, -most, most);
  for (std::size_t i = 0; i < kJoints; ++i) {
    reference.ddq[i] = rate_ * rate_ * reference.ddq[i] + change / dt * reference.dq[i];
    reference.dq[i] *= rate_;
  }
  rate_ += change;
  time_ = std::clamp(time_ + rate_ * dt, 0.0, trajectory_.duration());
  return reference;
}

Joints PathFollower::stopping_way() const {
  const Reference now = trajectory_.at(time_);
  const double time = std::abs(rate_) / steepest_rate(now, braking_);
  Joints way = now.dq;
  for (double& part : way) part *= rate_ * time / 2;
  return way;
}

}  // namespace race::robot
