// RateLimit: how fast a path may be run through (PathFollower) so that the tool keeps a speed.
#pragma once

#include <vector>

#include "services/robot/arm_model.h"
#include "services/robot/trajectory.h"

namespace race::robot {

class RateLimit {
 public:
  /// Of the tool centre point at most `tool_speed` [m/s, at least 0], forwards and backwards; `braking` [rad/s2] as the
  /// PathFollower has it: the rate falls early enough before a place where it must be low.
  RateLimit(const ArmModel& arm, const Trajectory& trajectory, const Joints& braking, double tool_speed);

  /// The highest rate at `time` [s] along the trajectory: 0..1.
  double at(double time) const;

 private:
  double spacing_;               // s between two places
  std::vector<double> squares_;  // of the rate, at equally spaced places; in between it goes straight, as braking does
};

}  // namespace race::robot
