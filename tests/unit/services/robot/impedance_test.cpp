// The compliance of each mode, measured: a known push moves the arm by force over stiffness.
#include "services/robot/impedance.h"

#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

Behavior soft(Mode mode) {
  Behavior behavior = usual_behavior(mode);
  behavior.reflexes.clear();
  return behavior;
}

class ToolStiffness : public testing::TestWithParam<std::size_t> {};

TEST_P(ToolStiffness, IsForceOverDisplacement) {
  const std::size_t axis = GetParam();
  Rig rig(empty_scene());
  Behavior behavior = soft(Mode::cartesian_impedance);
  behavior.operational.tool_stiffness = {500, 800, 1200, 100, 100, 100};
  rig.unit.set_behavior(behavior);
  rig.run(0.5);
  const Vec3 before = rig.world->pose("tcp").position;
  Vec3 force{};
  force[axis] = 15;
  rig.each_step = [&] { rig.world->push("gripper", force, rig.world->pose("tcp").position); };
  rig.run(4);
  Vec3 moved = rig.world->pose("tcp").position;
  for (std::size_t i = 0; i < 3; ++i) moved[i] -= before[i];
  const double expected = 15 / behavior.operational.tool_stiffness[axis];
  EXPECT_NEAR(moved[axis], expected, 0.03 * expected);
  for (std::size_t i = 0; i < 3; ++i) {
    if (i == axis) continue;
    EXPECT_NEAR(moved[i], 0, 0.03 * expected) << "axis " << i;
  }
  rig.each_step = {};
  rig.run(4);
  EXPECT_LT(distance(rig.world->pose("tcp").position, before), 5e-4) << "it comes back";
}

INSTANTIATE_TEST_SUITE_P(Axes, ToolStiffness, testing::Values(0U, 1U, 2U));

TEST(CartesianImpedance, TurnsByTorqueOverStiffness) {
  Rig rig(empty_scene());
  Behavior behavior = soft(Mode::cartesian_impedance);
  behavior.operational.tool_stiffness = {2000, 2000, 2000, 50, 50, 50};
  rig.unit.set_behavior(behavior);
  rig.run(0.5);
  const Pose before = rig.world->pose("tcp");
  // A couple of 20 N with an arm of 0.1 m about z.
  rig.each_step = [&] {
    const Vec3 p = rig.world->pose("tcp").position;
    rig.world->push("gripper", {0, 20, 0}, {p[0] + 0.05, p[1], p[2]});
    rig.world->push("gripper", {0, -20, 0}, {p[0] - 0.05, p[1], p[2]});
  };
  rig.run(4);
  EXPECT_NEAR(angle(rig.world->pose("tcp"), before), 2.0 / 50, 0.05 * 2.0 / 50);
  EXPECT_LT(distance(rig.world->pose("tcp").position, before.position), 1e-3);
}

TEST(CartesianImpedance, PullsWithNoMoreThanItsForceLimit) {
  Rig rig(empty_scene());
  Behavior behavior = soft(Mode::cartesian_impedance);
  behavior.operational.force = 10;
  rig.unit.set_behavior(behavior);
  rig.run(0.5);
  const double before = rig.world->pose("tcp").position[1];
  rig.each_step = [&] { rig.world->push("gripper", {0, 14, 0}, rig.world->pose("tcp").position); };
  rig.run(2);
  EXPECT_GT(rig.world->pose("tcp").position[1], before + 0.05) << "14 N overcome it; the spring would give 0.014 m";
}

TEST(CartesianImpedance, KeepsTheToolWhileAHandMovesTheElbow) {
  Rig rig(empty_scene());
  Behavior behavior = soft(Mode::cartesian_impedance);
  behavior.operational.tool_stiffness = {3000, 3000, 3000, 200, 200, 200};
  rig.unit.set_behavior(behavior);
  rig.run(0.5);
  const Pose before = rig.world->pose("tcp");
  const Vec3 elbow = rig.world->pose("link_4").position;
  rig.each_step = [&] { rig.world->push("link_4", {0, 40, 0}, rig.world->pose("link_4").position); };
  rig.run(3);
  EXPECT_GT(distance(rig.world->pose("link_4").position, elbow), 0.008) << "redundancy is soft";
  EXPECT_LT(distance(rig.world->pose("tcp").position, before.position), 0.015);
  rig.each_step = {};
  rig.run(5);
  EXPECT_LT(distance(rig.world->pose("link_4").position, elbow), 0.005) << "and comes back to its posture";
}

TEST(JointImpedance, DeflectsEachJointByTorqueOverStiffness) {
  Rig rig(empty_scene());
  Behavior behavior = soft(Mode::joint_impedance);
  behavior.operational.joint_stiffness = {300, 300, 200, 200, 100, 60, 60};
  rig.unit.set_behavior(behavior);
  rig.run(0.5);
  const Joints before = rig.world->q();
  rig.each_step = [&] { rig.world->push("gripper", {4, 8, -6}, rig.world->pose("tcp").position); };
  rig.run(4);
  const Joints now = rig.world->q();
  const Jacobian jacobian = rig.unit.arm().jacobian(now);
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double torque = 4 * jacobian[0][i] + 8 * jacobian[1][i] - 6 * jacobian[2][i];
    EXPECT_NEAR(now[i] - before[i], torque / behavior.operational.joint_stiffness[i], 1e-3) << "joint " << i + 1;
  }
}

class EachImpedance : public testing::TestWithParam<Mode> {};

TEST_P(EachImpedance, ArrivesWhereItIsSent) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = down_at(0.5, 0.2, 0.2)}, soft(GetParam())));
  for (int i = 0; i < 10000 && rig.unit.moving(); ++i) rig.step();
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome);
  ASSERT_FALSE(*outcome) << (*outcome)->message;
  rig.run(1);
  EXPECT_LT(distance(rig.world->pose("tcp").position, {0.5, 0.2, 0.2}), 2e-3);
}

TEST_P(EachImpedance, DoesNotSwingAfterAPush) {
  Rig rig(empty_scene());
  Behavior behavior = soft(GetParam());
  behavior.operational.damping = 1;
  rig.unit.set_behavior(behavior);
  rig.run(0.5);
  const double rest = rig.world->pose("tcp").position[1];
  rig.each_step = [&] { rig.world->push("gripper", {0, 20, 0}, rig.world->pose("tcp").position); };
  rig.run(2);
  const double deflection = rig.world->pose("tcp").position[1] - rest;
  ASSERT_GT(deflection, 0.003);
  double least = deflection;
  rig.each_step = [&] { least = std::min(least, rig.world->pose("tcp").position[1] - rest); };
  rig.run(3);
  EXPECT_GT(least, -0.1 * deflection) << "critically damped modes do not overshoot; their coupling does by little";
}

INSTANTIATE_TEST_SUITE_P(Modes, EachImpedance, testing::Values(Mode::joint_impedance, Mode::cartesian_impedance),
                         [](const auto& info) { return std::string(name(info.param)); });

TEST(Switching, BetweenAnyTwoModesMovesNothing) {
  const std::array modes = {Mode::position, Mode::joint_impedance, Mode::cartesian_impedance,
                            Mode::gravity_compensation};
  Rig rig(empty_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.45, 0.25, 0.3)}));
  const Vec3 before = rig.world->pose("tcp").position;
  Joints last = rig.world->torques();
  double jump = 0;
  rig.each_step = [&] {
    for (std::size_t i = 0; i < kJoints; ++i) jump = std::max(jump, std::abs(rig.world->torques()[i] - last[i]));
    last = rig.world->torques();
  };
  for (const Mode from : modes) {
    for (const Mode to : modes) {
      rig.unit.set_behavior(soft(from));
      rig.run(0.3);
      rig.unit.set_behavior(soft(to));
      rig.run(0.3);
    }
  }
  EXPECT_LT(distance(rig.world->pose("tcp").position, before), 5e-4) << "after 32 changes";
  EXPECT_LT(jump, 0.5) << "Nm in a millisecond";
}

TEST(Switching, UnderAPushLetsTheTorquePassOverGradually) {
  Rig rig(empty_scene());
  rig.each_step = [&] { rig.world->push("gripper", {0, 15, 0}, rig.world->pose("tcp").position); };
  rig.run(1);
  const Joints before = rig.world->torques();
  rig.unit.set_behavior(soft(Mode::cartesian_impedance));
  rig.step();
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->torques()[i], before[i], 0.5) << "joint " << i + 1;
}

class JointLimitsKept : public testing::TestWithParam<Mode> {};

TEST_P(JointLimitsKept, AgainstAHandThatPushesOn) {
  world::Scene scene = empty_scene();
  scene.robot.q = {2.7, -0.35, 0, 1.6, 0, -1.19, 0};
  Rig rig(scene);
  Behavior behavior = soft(GetParam());
  behavior.operational.tool_stiffness = {10, 10, 10, 1, 1, 1};
  behavior.operational.joint_stiffness = {5, 5, 5, 5, 5, 5, 5};
  rig.unit.set_behavior(behavior);
  rig.each_step = [&] {
    for (std::size_t i = 0; i < kJoints; ++i) {
      ASSERT_GT(rig.world->q()[i], rig.unit.arm().limits().lower[i]) << "joint " << i + 1;
      ASSERT_LT(rig.world->q()[i], rig.unit.arm().limits().upper[i]) << "joint " << i + 1;
    }
    const Vec3 p = rig.world->pose("tcp").position;
    const double radius = std::hypot(p[0], p[1]);
    rig.world->push("gripper", {-15 * p[1] / radius, 15 * p[0] / radius, 0}, p);
  };
  rig.run(2);
  EXPECT_GT(rig.world->q()[0], rig.unit.arm().limits().upper[0] - kLimitZone) << "it was pushed into the zone";
}

INSTANTIATE_TEST_SUITE_P(Modes, JointLimitsKept,
                         testing::Values(Mode::gravity_compensation, Mode::cartesian_impedance, Mode::joint_impedance),
                         [](const auto& info) { return std::string(name(info.param)); });

}  // namespace
}  // namespace race::robot
