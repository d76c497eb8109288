#include "services/robot/trajectory.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace race::robot {
namespace {

constexpr double kShortest = 0.02;  // s; also a motion to where the arm already stands
// s; less than a control cycle is a stand: its deceleration would be commanded for longer than it takes.
constexpr double kShortestBraking = 0.001;
constexpr int kChecks = 400;  // places of the time law where the limits are checked
// Peaks of the quintic's first and second derivative with respect to u.
constexpr double kPeakVelocity = 1.875;
const double kPeakAcceleration = 10.0 / std::sqrt(3.0);

struct TimeLaw {
  double s, ds, dds;  // value and derivatives with respect to u in [0, 1]
};

TimeLaw quintic(double u) {
  return {u * u * u * (10 - 15 * u + 6 * u * u), 30 * u * u * (1 - u) * (1 - u), 60 * u * (1 - u) * (1 - 2 * u)};
}

/// Second derivatives of the natural cubic spline at equally spaced knots `h` apart (Thomas' algorithm).
std::vector<Joints> spline_curvatures(const std::vector<Joints>& knots, double h) {
  std::vector<Joints> curvature(knots.size(), Joints{});
  const std::size_t last = knots.size() - 1;
  if (last < 2) return curvature;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    std::vector<double> upper(last, 0.0);
    std::vector<double> right(last, 0.0);
    for (std::size_t k = 1; k < last; ++k) {
      const double bend = 6 * (knots[k + 1][joint] - 2 * knots[k][joint] + knots[k - 1][joint]) / (h * h);
      const double pivot = 4 - upper[k - 1];
      upper[k] = 1 / pivot;
      right[k] = (bend - right[k - 1]) / pivot;
    }
    for (std::size_t k = last - 1; k > 0; --k) curvature[k][joint] = right[k] - upper[k] * curvature[k + 1][joint];
  }
  return curvature;
}

}  // namespace

Trajectory::Trajectory(std::vector<Joints> waypoints, const MotionLimits& limits, const std::vector<ToolLimits>& tool)
    : waypoints_(std::move(waypoints)) {
  assert(waypoints_.size() >= 2);
  curvatures_ = spline_curvatures(waypoints_, 1.0 / static_cast<double>(waypoints_.size() - 1));
  // Over a duration T velocities shrink with 1/T and accelerations with 1/T^2: T follows from the worst at T = 1.
  double duration = kShortest;
  for (int check = 0; check <= kChecks; ++check) {
    const TimeLaw law = quintic(static_cast<double>(check) / kChecks);
    const Reference path = along(law.s);
    for (std::size_t i = 0; i < kJoints; ++i) {
      const double velocity = std::abs(path.dq[i] * law.ds);
      const double acceleration = std::abs(path.dq[i] * law.dds + path.ddq[i] * law.ds * law.ds);
      duration = std::max({duration, velocity / limits.velocity[i], std::sqrt(acceleration / limits.acceleration[i])});
    }
  }
  for (const ToolLimits& limit : tool) {
    duration = std::max({duration, kPeakVelocity * limit.length / limit.velocity,
                         std::sqrt(kPeakAcceleration * limit.length / limit.acceleration)});
  }
  duration_ = duration;
}

Reference Trajectory::along(double s) const {
  const auto segments = static_cast<double>(waypoints_.size() - 1);
  const double place = std::clamp(s, 0.0, 1.0) * segments;
  const auto k = std::min(static_cast<std::size_t>(place), waypoints_.size() - 2);
  const double b = place - static_cast<double>(k);
  const double a = 1 - b;
  const double h = 1 / segments;
  Reference path;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double from = waypoints_[k][i];
    const double to = waypoints_[k + 1][i];
    const double from_bend = curvatures_[k][i];
    const double to_bend = curvatures_[k + 1][i];
    path.q[i] = a * from + b * to + ((a * a * a - a) * from_bend + (b * b * b - b) * to_bend) * h * h / 6;
    path.dq[i] = (to - from) / h + ((3 * b * b - 1) * to_bend - (3 * a * a - 1) * from_bend) * h / 6;
    path.ddq[i] = a * from_bend + b * to_bend;
  }
  return path;
}

Reference Trajectory::at(double t) const {
  const TimeLaw law = quintic(std::clamp(t / duration_, 0.0, 1.0));
  Reference reference = along(law.s);
  const double ds = law.ds / duration_;
  const double dds = law.dds / (duration_ * duration_);
  for (std::size_t i = 0; i < kJoints; ++i) {
    reference.ddq[i] = reference.ddq[i] * ds * ds + reference.dq[i] * dds;
    reference.dq[i] *= ds;
  }
  return reference;
}

Braking::Braking(const Joints& q, const Joints& dq, const Joints& acceleration) : q_(q), dq_(dq) {
  for (std::size_t i = 0; i < kJoints; ++i) duration_ = std::max(duration_, std::abs(dq[i]) / acceleration[i]);
  if (duration_ >= kShortestBraking) return;
  duration_ = 0;
  dq_ = {};
}

Reference Braking::at(double t) const {
  Reference reference{q_, {}, {}};
  if (duration_ == 0) return reference;
  const double now = std::clamp(t, 0.0, duration_);
  const bool moving = t < duration_;
  for (std::size_t i = 0; i < kJoints; ++i) {
    reference.q[i] += dq_[i] * (now - now * now / (2 * duration_));
    reference.dq[i] = moving ? dq_[i] * (1 - now / duration_) : 0.0;
    reference.ddq[i] = moving ? -dq_[i] / duration_ : 0.0;
  }
  return reference;
}

}  // namespace race::robot
