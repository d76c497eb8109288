#include "services/robot/ik.h"

#include <random>

#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

constexpr unsigned kSeed = 20140131;

Joints random_posture(const JointLimits& limits, std::mt19937& random) {
  Joints q;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double margin = 0.05;
    q[i] = std::uniform_real_distribution(limits.lower[i] + margin, limits.upper[i] - margin)(random);
  }
  return q;
}

TEST(Ik, ReachesEveryPoseThatAPostureWithinTheLimitsHas) {
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const ArmModel arm = make_arm(*Rig::make_world(empty_scene()));
  std::mt19937 random(kSeed);
  IkOptions options;
  options.preferred = lwr_settings().planner.preferred;
  const int cases = 1000;
  int missed = 0;
  for (int i = 0; i < cases; ++i) {
    const Pose target = arm.forward(random_posture(arm.limits(), random));
    const auto q = solve_ik(arm, target, options.preferred, options);
    if (!q) {
      ++missed;
      continue;
    }
    ASSERT_LT(distance(arm.forward(*q).position, target.position), 1e-6) << "case " << i;
    ASSERT_LT(angle(arm.forward(*q), target), 1e-6) << "case " << i;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      ASSERT_GE((*q)[joint], arm.limits().lower[joint]) << "case " << i;
      ASSERT_LE((*q)[joint], arm.limits().upper[joint]) << "case " << i;
    }
  }
  RecordProperty("missed", missed);
  EXPECT_LE(missed, cases / 200) << "of " << cases;
}

TEST(Ik, FindsNothingBeyondTheReach) {
  const ArmModel arm = make_arm(*Rig::make_world(empty_scene()));
  std::mt19937 random(kSeed);
  for (int i = 0; i < 20; ++i) {
    const double turn = std::uniform_real_distribution(-3.0, 3.0)(random);
    const Pose target = down_at(1.1 * std::cos(turn), 1.1 * std::sin(turn), 0.31);
    EXPECT_FALSE(solve_ik(arm, target, Joints{}, IkOptions{})) << "case " << i;
  }
}

TEST(Ik, StaysInThePresentConfigurationForANearTarget) {
  const ArmModel arm = make_arm(*Rig::make_world(empty_scene()));
  IkOptions options;
  options.preferred = lwr_settings().planner.preferred;
  Pose target = arm.forward(options.preferred);
  target.position[1] += 0.05;
  const auto q = solve_ik(arm, target, options.preferred, options);
  ASSERT_TRUE(q);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR((*q)[i], options.preferred[i], 0.2);
}

}  // namespace
}  // namespace race::robot
