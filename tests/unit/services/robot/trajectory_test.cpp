// Time laws by their mathematics alone.
#include "services/robot/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace race::robot {
namespace {

constexpr MotionLimits kLimits{{1, 1, 1, 1, 1, 1, 1}, {3, 3, 3, 3, 3, 3, 3}};

/// A path that bends: waypoints on a sine.
std::vector<Joints> bent_path() {
  std::vector<Joints> waypoints;
  for (int i = 0; i <= 20; ++i) {
    const double s = i / 20.0;
    waypoints.push_back({s, 0.5 * std::sin(3 * s), -s * s, 0, 0.2 * s, 0, 0.1});
  }
  return waypoints;
}

TEST(Trajectory, PassesItsWaypointsAndStandsAtBothEnds) {
  const auto waypoints = bent_path();
  const Trajectory trajectory(waypoints, kLimits);
  for (const double t : {-1.0, 0.0, trajectory.duration(), trajectory.duration() + 1}) {
    const Reference reference = trajectory.at(t);
    const Joints& expected = t <= 0 ? waypoints.front() : waypoints.back();
    for (std::size_t i = 0; i < kJoints; ++i) {
      EXPECT_NEAR(reference.q[i], expected[i], 1e-12);
      EXPECT_NEAR(reference.dq[i], 0, 1e-12);
      EXPECT_NEAR(reference.ddq[i], 0, 1e-9);
    }
  }
  const Joints middle = trajectory.at(trajectory.duration() / 2).q;  // s = 1/2 at half the time
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(middle[i], waypoints[10][i], 1e-12);
}

TEST(Trajectory, GivesTheDerivativesOfItsPositions) {
  const Trajectory trajectory(bent_path(), kLimits);
  const double h = 1e-4;
  for (double t = 0.1; t < trajectory.duration() - 0.1; t += 0.05) {
    const Reference before = trajectory.at(t - h);
    const Reference now = trajectory.at(t);
    const Reference after = trajectory.at(t + h);
    for (std::size_t i = 0; i < kJoints; ++i) {
      EXPECT_NEAR(now.dq[i], (after.q[i] - before.q[i]) / (2 * h), 1e-5) << "joint " << i << " at " << t;
      EXPECT_NEAR(now.ddq[i], (after.dq[i] - before.dq[i]) / (2 * h), 1e-3) << "joint " << i << " at " << t;
    }
  }
}

TEST(Trajectory, TouchesOneLimitAndPassesNone) {
  const Trajectory trajectory(bent_path(), kLimits);
  double worst = 0;
  for (double t = 0; t < trajectory.duration(); t += 1e-3) {
    const Reference now = trajectory.at(t);
    for (std::size_t i = 0; i < kJoints; ++i) worst = std::max({worst, std::abs(now.dq[i]), std::abs(now.ddq[i]) / 3});
  }
  EXPECT_LE(worst, 1.001);
  EXPECT_GE(worst, 0.98);
}

TEST(Trajectory, KeepsTheToolsLimits) {
  const std::vector<Joints> way = {Joints{}, Joints{0.01}};
  EXPECT_NEAR(Trajectory(way, kLimits, {{0.5, 0.25, 100}}).duration(), 1.875 * 0.5 / 0.25, 1e-9);
  EXPECT_NEAR(Trajectory(way, kLimits, {{0.5, 100, 2}}).duration(), std::sqrt(10 / std::sqrt(3.0) * 0.5 / 2), 1e-9);
}

TEST(Braking, StopsAllJointsTogether) {
  const Joints deceleration = {8, 8, 8, 8, 8, 8, 8};
  const Braking braking(Joints{}, {2, -1, 0, 0, 0, 0, 0.5}, deceleration);
  EXPECT_DOUBLE_EQ(braking.duration(), 2.0 / 8);
  EXPECT_NEAR(braking.goal()[0], 2 * 0.25 / 2, 1e-12);
  EXPECT_NEAR(braking.goal()[1], -1 * 0.25 / 2, 1e-12);
  EXPECT_EQ(braking.at(0.1).ddq[0], -8);
  EXPECT_EQ(braking.at(0.3).dq, Joints{});
}

}  // namespace
}  // namespace race::robot
