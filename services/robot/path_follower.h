// PathFollower: runs along a trajectory with a rate that may change on the way: slower, paused, backwards. The path in
// joint space stays the same; only its time is scaled.
#pragma once

#include "services/robot/trajectory.h"

namespace race::robot {

/// The most that the rate may change in a second where the path, run through as planned, is at `place`: no joint pays
/// more than `braking` [rad/s2] for it.
double steepest_rate(const Reference& place, const Joints& braking);

class PathFollower {
 public:
  /// Begins at the trajectory's start with `rate`; `braking` [rad/s2] bounds what a change of the rate costs.
  PathFollower(Trajectory trajectory, const Joints& braking, double rate)
      : trajectory_(std::move(trajectory)), braking_(braking), rate_(rate) {}

  /// The reference of the next cycle of `dt` seconds, on the way to `rate`: 1 is the plan, 0 a pause, negative is back.
  /// At the start, where nothing moves, any rate is there at once.
  Reference advance(double rate, double dt);

  /// Where it will be after `dt` seconds, s along the trajectory.
  double next_time(double dt) const { return time_ + rate_ * dt; }
  /// What each joint still moves, rad, if it slows down to a stand from now on.
  Joints stopping_way() const;
  bool backwards() const { return rate_ < 0; }
  bool at_start() const { return time_ <= 0; }
  bool at_end() const { return time_ >= trajectory_.duration(); }
  /// Whether it stands still on its way.
  bool standing() const { return rate_ == 0; }
  const Trajectory& trajectory() const { return trajectory_; }

 private:
  Trajectory trajectory_;
  Joints braking_;
  double time_ = 0;  // s along the trajectory
  double rate_;
};

}  // namespace race::robot
