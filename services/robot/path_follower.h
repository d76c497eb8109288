// PathFollower: runs along a trajectory with a rate that may change on the way: slower, paused, backwards. The path in
// joint space stays the same; only its time is scaled.
#pragma once

#include "services/robot/trajectory.h"

namespace race::robot {

class PathFollower {
 public:
  /// Begins at the trajectory's start with `rate`; `braking` [rad/s2] bounds what a change of the rate costs.
  PathFollower(Trajectory trajectory, const Joints& braking, double rate)
      : trajectory_(std::move(trajectory)), braking_(braking), rate_(rate) {}

  /// The reference of the next cycle of `dt` seconds, on the way to `rate`: 1 is the plan, 0 a pause, negative is back.
  Reference advance(double rate, double dt);

  /// What each joint still moves, rad, if it slows down to a stand from now on.
  Joints stopping_way() const;
  bool backwards() const { return rate_ < 0; }
  bool at_start() const { return time_ <= 0; }
  bool at_end() const { return time_ >= trajectory_.duration(); }
  /// Whether it stands still on its way.
  bool standing() const { return rate_ == 0; }
  const Trajectory& trajectory() const { return trajectory_; }

 private:
  double steepest(const Reference& now) const;

  Trajectory trajectory_;
  Joints braking_;
  double time_ = 0;  // s along the trajectory
  double rate_;
};

}  // namespace race::robot
