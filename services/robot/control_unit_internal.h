// What the files of ControlUnit share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "services/robot/arm_model.h"

namespace race::robot {

inline constexpr double kFollowingError = 0.03;  // rad; more means that something pushes the arm off its path
inline constexpr double kStanding = 0.02;        // rad/s
inline constexpr double kArrivalTimeout = 1.0;   // s that an arrival may take longer than planned
inline constexpr double kBlendTime = 0.2;        // s from one control law to the next

inline double largest_difference(const Joints& a, const Joints& b) {
  double largest = 0;
  for (std::size_t i = 0; i < kJoints; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace race::robot
