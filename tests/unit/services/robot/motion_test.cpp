// Motions on the real plant: they arrive where they should, keep their limits, and never begin when they should not.
#include <limits>
#include <random>

#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

constexpr double kDegree = 0.017453292519943295;

/// Watches speeds and torques of every step.
struct Watch {
  explicit Watch(Rig& rig) : rig_(rig) {
    rig.each_step = [this] { look(); };
  }
  void look() {
    for (std::size_t i = 0; i < kJoints; ++i) {
      speed[i] = std::max(speed[i], std::abs(rig_.world->dq()[i]));
      torque[i] = std::max(torque[i], std::abs(rig_.world->torques()[i]));
    }
  }
  Rig& rig_;
  Joints speed{}, torque{};
};

TEST(PointToPoint, ArrivesAtJointPositions) {
  Rig rig(empty_scene());
  const Joints target = {0.8, -0.9, -0.4, 1.2, 0.5, -0.7, 1.0};
  EXPECT_FALSE(rig.move({.target = target}));
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], target[i], 1e-3);
}

TEST(PointToPoint, ArrivesAtAPose) {
  Rig rig(empty_scene());
  for (const Pose& target : {down_at(0.5, 0.3, 0.2), down_at(0.3, -0.5, 0.4), down_at(0.6, 0.0, 0.05)}) {
    const auto failure = rig.move({.target = target, .speed = 1, .acceleration = 1});
    ASSERT_FALSE(failure) << failure->message;
    EXPECT_LT(distance(rig.world->pose("tcp").position, target.position), 1e-3);
    EXPECT_LT(angle(rig.world->pose("tcp"), target), 0.5 * kDegree);
  }
}

TEST(Linear, StaysOnItsLineAndKeepsTheOrientation) {
  Rig rig(empty_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.5, -0.25, 0.2)}));
  const Pose goal = down_at(0.45, 0.3, 0.35);
  const Vec3 from = rig.world->pose("tcp").position;
  double off_line = 0;
  double turned = 0;
  rig.each_step = [&] {
    const Pose now = rig.world->pose("tcp");
    Vec3 way, gone;
    double length = 0;
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      way[i] = goal.position[i] - from[i];
      gone[i] = now.position[i] - from[i];
      length += way[i] * way[i];
      along += way[i] * gone[i];
    }
    for (std::size_t i = 0; i < 3; ++i) gone[i] -= along / length * way[i];
    off_line = std::max(off_line, std::hypot(gone[0], gone[1], gone[2]));
    turned = std::max(turned, angle(now, goal));
  };
  const auto failure = rig.move({.target = goal, .kind = MotionKind::linear, .speed = 1, .acceleration = 1});
  ASSERT_FALSE(failure) << failure->message;
  EXPECT_LT(distance(rig.world->pose("tcp").position, goal.position), 1e-3);
  EXPECT_LT(off_line, 1e-3);
  EXPECT_LT(turned, 0.5 * kDegree);
}

TEST(Linear, FollowsAnOffsetAlongTheWorld) {
  Rig rig(empty_scene());
  const Vec3 before = rig.world->pose("tcp").position;
  ASSERT_FALSE(rig.move({.target = Offset{{0.05, -0.02, -0.1}}, .kind = MotionKind::linear}));
  const Vec3 after = rig.world->pose("tcp").position;
  EXPECT_NEAR(after[0] - before[0], 0.05, 1e-3);
  EXPECT_NEAR(after[1] - before[1], -0.02, 1e-3);
  EXPECT_NEAR(after[2] - before[2], -0.1, 1e-3);
}

TEST(Limits, AreKeptByRandomMotions) {
  constexpr unsigned seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Rig rig(empty_scene());
  Watch watch(rig);
  std::mt19937 random(seed);
  const JointLimits& limits = rig.unit.arm().limits();
  for (int i = 0; i < 12; ++i) {
    Joints target;
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      target[joint] = std::uniform_real_distribution(limits.lower[joint], limits.upper[joint])(random);
    const double speed = std::uniform_real_distribution(0.2, 1.0)(random);
    watch.speed = {};
    const auto failure = rig.move({.target = target, .speed = speed, .acceleration = 1});
    ASSERT_FALSE(failure) << failure->message;
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      EXPECT_LE(watch.speed[joint], 1.02 * speed * limits.velocity[joint] + 0.01) << "joint " << joint + 1;
  }
  // Below, not at: a torque at its limit would be one that the drive did not give in full.
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    EXPECT_LT(watch.torque[joint], limits.effort[joint]) << "joint " << joint + 1;
}

TEST(Limits, HalfTheSpeedTakesTwiceTheTime) {
  const MotionLimits limits{{2, 2, 2, 2, 2, 2, 2}, {1e9, 1e9, 1e9, 1e9, 1e9, 1e9, 1e9}};
  MotionLimits half = limits;
  for (double& velocity : half.velocity) velocity /= 2;
  const std::vector<Joints> way = {Joints{}, Joints{1, -0.5, 0, 0, 0, 0, 0}};
  EXPECT_NEAR(Trajectory(way, limits).duration(), 1.875 / 2, 1e-9);
  EXPECT_NEAR(Trajectory(way, half).duration(), 1.875, 1e-9);
}

struct Refused {
  const char* name;
  MoveCommand command;
  const char* code;
};

class Refusals : public testing::TestWithParam<Refused> {};

TEST_P(Refusals, NeverMoveTheArm) {
  Rig rig(empty_scene());
  rig.run(0.1);
  const Joints before = rig.world->q();
  const auto accepted = rig.unit.move(GetParam().command);
  ASSERT_FALSE(accepted);
  EXPECT_EQ(accepted.error().code, GetParam().code);
  EXPECT_FALSE(accepted.error().message.empty());
  EXPECT_FALSE(rig.unit.moving());
  rig.run(0.5);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], before[i], 1e-6);
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Move, Refusals,
    testing::Values(
        Refused{"JointBeyondItsLimit", {.target = Joints{0, 2.2, 0, 0, 0, 0, 0}}, "joint_limits"},
        Refused{"JointNotANumber", {.target = Joints{0, kNan, 0, 0, 0, 0, 0}}, "out_of_range"},
        Refused{"PoseNotANumber", {.target = down_at(0.5, kNan, 0.2)}, "out_of_range"},
        Refused{"PoseInfinite", {.target = down_at(0.5, std::numeric_limits<double>::infinity(), 0.2)}, "out_of_range"},
        Refused{"PoseOutOfReach", {.target = down_at(1.5, 0, 0.2)}, "unreachable"},
        Refused{"PoseInsideTheBase", {.target = down_at(0, 0, 0.31)}, "unreachable"},
        Refused{"NoQuaternion", {.target = Pose{{0.5, 0, 0.2}, {0, 0, 0, 0}}}, "out_of_range"},
        Refused{"LineOutOfReach", {.target = Offset{{1, 0, 0}}, .kind = MotionKind::linear}, "path"},
        Refused{"NoSpeed", {.target = down_at(0.5, 0, 0.2), .speed = 0}, "out_of_range"},
        Refused{"TooFast", {.target = down_at(0.5, 0, 0.2), .speed = 1.01}, "out_of_range"},
        Refused{"SpeedNotANumber", {.target = down_at(0.5, 0, 0.2), .speed = kNan}, "out_of_range"},
        Refused{"NegativeAcceleration", {.target = down_at(0.5, 0, 0.2), .acceleration = -0.5}, "out_of_range"}),
    [](const auto& info) { return info.param.name; });

TEST(Refusals, AMotionWhileMovingOrLedByHand) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = down_at(0.5, 0.2, 0.2)}));
  rig.run(0.3);
  EXPECT_EQ(rig.unit.move({.target = down_at(0.5, 0, 0.2)}).error().code, "busy");
  rig.unit.stop();
  rig.run(0.5);
  rig.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  EXPECT_EQ(rig.unit.move({.target = down_at(0.5, 0, 0.2)}).error().code, "behavior");
}

TEST(Stop, BrakesWithinItsDecelerationAndHolds) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = Joints{1.5, -0.9, 0, 1.2, 0, -0.7, 0}, .speed = 1, .acceleration = 1}));
  rig.run(0.7);
  const double speed = std::abs(rig.world->dq()[0]);
  ASSERT_GT(speed, 0.5);
  rig.unit.stop();
  const double q = rig.world->q()[0];
  const double braking = lwr_settings().braking[0];
  rig.run(speed / braking + 0.15);
  EXPECT_LT(std::abs(rig.world->dq()[0]), 0.01);
  EXPECT_NEAR(rig.world->q()[0] - q, speed * speed / (2 * braking), 0.02);
  const Joints held = rig.world->q();
  rig.run(2);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], held[i], 1e-3);
  EXPECT_FALSE(rig.unit.moving());
  EXPECT_FALSE(rig.unit.take_outcome());
}

TEST(Stop, LetsTheNextMotionBeginAfterBraking) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = Joints{1.5, -0.9, 0, 1.2, 0, -0.7, 0}, .speed = 1, .acceleration = 1}));
  rig.run(0.7);
  rig.unit.stop();
  const Pose target = down_at(0.5, 0, 0.2);
  const auto failure = rig.move({.target = target});
  ASSERT_FALSE(failure) << failure->message;
  EXPECT_LT(distance(rig.world->pose("tcp").position, target.position), 1e-3);
}

TEST(Motion, FailsWhenSomethingIsInItsWay) {
  Rig rig(demo_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.6, -0.32, 0.05)}));
  const auto failure = rig.move({.target = Offset{{0, 0, -0.12}}, .kind = MotionKind::linear, .speed = 0.3});
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code, "collision");
  EXPECT_EQ(failure->reaction, "stop");
  rig.run(1);
  EXPECT_LT(std::abs(rig.world->dq()[1]), 0.01);
}

}  // namespace
}  // namespace race::robot
