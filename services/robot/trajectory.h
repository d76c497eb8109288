// Trajectories in joint space: a path with a time law that respects speed and acceleration limits, and braking.
#pragma once

#include <vector>

#include "services/robot/arm_model.h"

namespace race::robot {

/// What the position controller follows: where the joints should be, how fast, and how that changes.
struct Reference {
  Joints q{};    // rad
  Joints dq{};   // rad/s
  Joints ddq{};  // rad/s2
};

/// Limits of a motion: joints always; the tool's path and turning only where it is followed in Cartesian space.
struct MotionLimits {
  Joints velocity{};      // rad/s
  Joints acceleration{};  // rad/s2
};

/// How far a motion moves the tool along its path, and how fast it may.
struct ToolLimits {
  double length = 0;  // m or rad, of the whole path
  double velocity = 0;
  double acceleration = 0;
};

/// Runs through waypoints, equally spaced in the path parameter s, along a cubic spline (natural ends; two waypoints:
/// a straight line in joint space). The time law is the quintic s(t) = 10u^3 - 15u^4 + 6u^5, u = t / duration: all
/// joints start and arrive together, without jumps of acceleration.
class Trajectory {
 public:
  /// The shortest duration that keeps every limit. Requires at least two waypoints and positive limits.
  Trajectory(std::vector<Joints> waypoints, const MotionLimits& limits, const std::vector<ToolLimits>& tool = {});

  double duration() const { return duration_; }
  /// Takes `factor` times as long. Requires at least 1.
  void stretch(double factor) { duration_ *= factor; }
  /// Before 0 it stands at the first waypoint, after duration() at the last.
  Reference at(double t) const;
  const Joints& goal() const { return waypoints_.back(); }

 private:
  Reference along(double s) const;  // q, dq/ds, d2q/ds2

  std::vector<Joints> waypoints_;
  std::vector<Joints> curvatures_;  // second derivatives at the waypoints
  double duration_ = 0;
};

/// Slows all joints down together to a stand, in the shortest time that `acceleration` allows.
class Braking {
 public:
  Braking() = default;
  Braking(const Joints& q, const Joints& dq, const Joints& acceleration);

  double duration() const { return duration_; }
  Reference at(double t) const;
  Joints goal() const { return at(duration_).q; }

 private:
  Joints q_{}, dq_{};
  double duration_ = 0;
};

}  // namespace race::robot
