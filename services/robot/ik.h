// Inverse kinematics: joint positions for a pose of the tool centre point, within the joint limits.
#pragma once

#include <functional>
#include <optional>

#include "services/robot/arm_model.h"

namespace race::robot {

struct IkOptions {
  Joints preferred{};                   // rad; redundancy is resolved towards this posture
  double position_tolerance = 1e-7;     // m
  double orientation_tolerance = 1e-7;  // rad
  int iterations = 150;                 // per seed
  double margin = 0.01;                 // rad kept from the joint limits
  double null_space_gain = 0.15;        // share of the way to `preferred` per iteration; small: stays near the seed
};

/// Damped least squares from one seed, pulled towards `preferred` in the null space. None: not found from there.
std::optional<Joints> solve_ik_from(const ArmModel& arm, const Pose& target, const Joints& seed,
                                    const IkOptions& options);

/// From `current` first, so that near targets are reached in the present configuration, then from the preferred posture
/// turned towards the target, then from a fixed sequence of seeds spread over the joint ranges. The same arguments give
/// the same answer: the first that `accept`, if given, takes.
std::optional<Joints> solve_ik(const ArmModel& arm, const Pose& target, const Joints& current, const IkOptions& options,
                               const std::function<bool(const Joints&)>& accept = {});

}  // namespace race::robot
