// The limit of the tool's speed from outside of tasks: whatever moves keeps it, over whole motions.
#include <cmath>
#include <random>

#include "tests/unit/services/robot/crash.h"

namespace race::robot {
namespace {

constexpr double kLimit = 0.25;  // m/s, the reduced speed of ISO 10218-1

/// The tool's speed in each cycle, m/s: of what it moves, by its places.
struct ToolSpeed {
  explicit ToolSpeed(Rig& rig) {
    rig.each_step = [this, &rig, before = rig.world->pose("tcp").position]() mutable {
      const Vec3 there = rig.world->pose("tcp").position;
      now = distance(there, before) / ControlUnit::kPeriod;
      fastest = std::max(fastest, now);
      before = there;
    };
  }
  double now = 0, fastest = 0;
};

constexpr Joints kAside = {1.2, -0.6, 0, 1.4, 0, -1.1, 0};

struct Motion {
  const char* name;
  MoveCommand command;
};

class EveryMotion : public testing::TestWithParam<std::tuple<Motion, Mode>> {};

TEST_P(EveryMotion, KeepsTheLimitOfSpeed) {
  const auto& [motion, mode] = GetParam();
  Rig rig(empty_scene());
  ToolSpeed tool(rig);
  ASSERT_FALSE(rig.move(motion.command, usual_behavior(mode)));
  EXPECT_GT(tool.fastest, 1.5 * kLimit) << "it would be faster";
  ASSERT_FALSE(rig.move({.target = Joints{0, -0.35, 0, 1.6, 0, -1.19, 0}}));
  rig.run(0.5);
  tool.fastest = 0;
  rig.unit.set_tool_speed_limit(kLimit);
  ASSERT_FALSE(rig.move(motion.command));
  EXPECT_LE(tool.fastest, kLimit * (mode == Mode::position ? 1 : 1.03));
  EXPECT_GT(tool.fastest, 0.95 * kLimit) << "nor is it slower than it needs to be";
}

INSTANTIATE_TEST_SUITE_P(
    LimitOfSpeed, EveryMotion,
    testing::Combine(
        testing::Values(
            Motion{"ptp", {.target = kAside, .speed = 1, .acceleration = 1}},
            Motion{"lin",
                   {.target = Offset{{-0.1, 0.4, 0.1}}, .kind = MotionKind::linear, .speed = 1, .acceleration = 1}},
            Motion{"free", {.target = kAside, .kind = MotionKind::free, .speed = 1, .acceleration = 1}}),
        testing::Values(Mode::position, Mode::joint_impedance, Mode::cartesian_impedance)),
    [](const auto& info) {
      return std::string(std::get<0>(info.param).name) + "_" + std::string(name(std::get<1>(info.param)));
    });

TEST(LimitOfSpeed, IsKeptByRandomMotionsWhateverItIs) {
  constexpr unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  Rig rig(empty_scene());
  ToolSpeed tool(rig);
  const JointLimits& limits = rig.unit.arm().limits();
  for (int i = 0; i < 12; ++i) {
    Joints target;
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      target[joint] = std::uniform_real_distribution(limits.lower[joint], limits.upper[joint])(random);
    const double limit = std::uniform_real_distribution(0.05, 0.6)(random);
    rig.unit.set_tool_speed_limit(limit);
    tool.fastest = 0;
    const auto accepted = rig.unit.move({.target = target, .speed = 1, .acceleration = 1});
    ASSERT_TRUE(accepted);
    for (int step = 0; step < 60000 && rig.unit.moving(); ++step) rig.step();
    EXPECT_FALSE(rig.unit.moving());
    EXPECT_LE(tool.fastest, limit) << "motion " << i;
    rig.unit.stop();
  }
}

TEST(LimitOfSpeed, IsKeptFromTheFirstCycleOn) {
  for (const double limit : {0.001, 0.005}) {
    Rig rig(empty_scene());
    ToolSpeed tool(rig);
    rig.unit.set_tool_speed_limit(limit);
    ASSERT_TRUE(rig.unit.move({.target = kAside, .speed = 1, .acceleration = 1}));
    rig.run(2);
    EXPECT_LE(tool.fastest, 1.03 * limit);
    EXPECT_GT(tool.now, 0.9 * limit);
  }
}

TEST(RateLimit, NeverFallsOrRisesFasterThanBrakingAllows) {
  constexpr unsigned seed = 3;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const Rig rig(empty_scene());
  const ArmModel& arm = rig.unit.arm();
  const Joints braking = lwr_settings().braking;
  const auto anywhere = [&] {
    Joints q;
    for (std::size_t i = 0; i < kJoints; ++i)
      q[i] = std::uniform_real_distribution(arm.limits().lower[i], arm.limits().upper[i])(random);
    return q;
  };
  for (int i = 0; i < 20; ++i) {
    const Trajectory trajectory({anywhere(), anywhere()}, {arm.limits().velocity, lwr_settings().planner.acceleration});
    const RateLimit limit(arm, trajectory, braking, 0.02);
    const double step = trajectory.duration() / 400;
    for (double time = 0; time < trajectory.duration(); time += step) {
      const double change = std::pow(limit.at(time + step), 2) - std::pow(limit.at(time), 2);
      EXPECT_LE(std::abs(change) / 2 / step, 1.1 * steepest_rate(trajectory.at(time + step / 2), braking))
          << "trajectory " << i << " at " << time << " s";
    }
  }
}

TEST(LimitOfSpeed, IsKeptOnTheWayBack) {
  Rig rig(empty_scene());
  ToolSpeed tool(rig);
  const double wall = rig.world->pose("tcp").position[1] + 0.2;
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0.4, 0}}, .kind = MotionKind::linear, .speed = 1, .acceleration = 1},
                            position_with({{.signal = Signal::virtual_wall,
                                            .reaction = Reaction::retreat,
                                            .wall = Plane{{0, wall, 0}, {0, -1, 0}},
                                            .distance = 0.2}})));
  rig.unit.set_tool_speed_limit(0.1);
  while (rig.unit.take_incidents().empty()) rig.step();
  const double turned = rig.world->pose("tcp").position[1];
  while (rig.unit.moving()) rig.step();
  EXPECT_LT(rig.world->pose("tcp").position[1], turned - 0.1) << "it has gone back";
  EXPECT_LE(tool.fastest, 0.1);
  EXPECT_GT(tool.fastest, 0.09);
}

TEST(LimitOfSpeed, IsKeptByJogging) {
  Rig rig(empty_scene());
  ToolSpeed tool(rig);
  const auto hold = [&](const JogVelocity& wanted, double seconds) {
    tool.fastest = 0;
    for (int i = 0; i < std::lround(seconds * 20); ++i) {
      ASSERT_TRUE(rig.unit.jog(wanted));
      rig.run(0.05);
    }
  };
  hold(Joints{0.9, 0, 0, 0, 0, 0, 0}, 1);
  EXPECT_GT(tool.fastest, 1.2 * kLimit) << "joints alone are not limited by the tool";
  rig.unit.set_tool_speed_limit(kLimit);
  rig.run(0.1);
  hold(Joints{-0.9, 0, 0, 0, 0, 0, 0}, 1);
  EXPECT_LE(tool.fastest, kLimit);
  EXPECT_GT(tool.fastest, 0.95 * kLimit);
  hold(ToolVelocity{{0, 0.25, 0}, {}, {}}, 1);
  EXPECT_LE(tool.fastest, kLimit);
  rig.unit.set_tool_speed_limit(0.05);
  rig.run(0.1);
  hold(ToolVelocity{{0, -0.25, 0}, {0, 0, 0.5}, {}}, 1);
  EXPECT_LE(tool.fastest, 0.05);
  EXPECT_GT(tool.fastest, 0.045);
}

TEST(LimitOfSpeed, OfABehaviorIsKeptByJoggingToo) {
  Rig rig(empty_scene());
  Behavior behavior = usual_behavior(Mode::position);
  behavior.operational.speed = 0.1;
  rig.unit.set_behavior(behavior);
  rig.run(0.3);  // the torques of its law are blended in
  ToolSpeed tool(rig);
  const auto jog = [&] {
    tool.fastest = 0;
    for (int i = 0; i < 10; ++i) {
      ASSERT_TRUE(rig.unit.jog(ToolVelocity{{0, 0.25, 0}, {}, {}}));
      rig.run(0.05);
    }
  };
  jog();
  EXPECT_NEAR(tool.fastest, 0.1, 0.001);
  rig.unit.set_tool_speed_limit(0.2);
  jog();
  EXPECT_NEAR(tool.fastest, 0.1, 0.001);
  rig.unit.set_tool_speed_limit(0.05);
  rig.run(0.1);
  jog();
  EXPECT_LE(tool.fastest, 0.05);
}

TEST(LimitOfSpeed, BringsAMotionDownAsFastAsBrakingAllows) {
  for (const MotionKind kind : {MotionKind::point_to_point, MotionKind::linear}) {
    Rig rig(empty_scene());
    ToolSpeed tool(rig);
    const Target target = kind == MotionKind::linear ? Target(Offset{{-0.1, 0.45, 0}}) : Target(Joints(kAside));
    ASSERT_TRUE(rig.unit.move({.target = target, .kind = kind, .speed = 1, .acceleration = 1}));
    while (tool.now < 0.45) rig.step();
    double time = 0;  // s in which the joint that needs longest would brake to a stand
    for (std::size_t i = 0; i < kJoints; ++i)
      time = std::max(time, std::abs(rig.world->dq()[i]) / lwr_settings().braking[i]);
    rig.unit.set_tool_speed_limit(kLimit);
    rig.run(time);
    EXPECT_LE(tool.now, kLimit);
    tool.fastest = 0;
    while (rig.unit.moving()) rig.step();
    EXPECT_LE(tool.fastest, kLimit);
    const auto outcome = rig.unit.take_outcome();
    ASSERT_TRUE(outcome);
    EXPECT_FALSE(*outcome) << "it arrives nevertheless";
  }
}

TEST(LimitOfSpeed, BringsAJogDown) {
  Rig rig(empty_scene());
  ToolSpeed tool(rig);
  const auto hold = [&] {
    ASSERT_TRUE(rig.unit.jog(Joints{0.9, 0, 0, 0, 0, 0, 0}));
    rig.run(0.05);
  };
  for (int i = 0; i < 20; ++i) hold();
  ASSERT_GT(tool.now, 0.3);
  rig.unit.set_tool_speed_limit(0.1);
  hold();
  hold();
  EXPECT_LE(tool.now, 0.1);
  EXPECT_TRUE(rig.unit.moving());
}

TEST(LimitOfSpeed, LetsAMotionSpeedUpAgainWhenItIsGone) {
  Rig rig(empty_scene());
  ToolSpeed tool(rig);
  rig.unit.set_tool_speed_limit(0.1);
  ASSERT_TRUE(rig.unit.move({.target = kAside, .speed = 1, .acceleration = 1}));
  rig.run(1);
  EXPECT_LE(tool.fastest, 0.1);
  rig.unit.set_tool_speed_limit({});
  while (rig.unit.moving()) rig.step();
  EXPECT_GT(tool.fastest, 0.4);
}

TEST(LimitOfSpeed, OfZeroPausesOnThePath) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = kAside}));
  rig.run(0.5);
  rig.unit.set_tool_speed_limit(0);
  rig.run(0.5);
  const Joints paused = rig.world->q();
  rig.run(1);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], paused[i], 1e-4);
  EXPECT_TRUE(rig.unit.moving());
  rig.unit.set_tool_speed_limit(kLimit);
  while (rig.unit.moving()) rig.step();
  EXPECT_NEAR(rig.world->q()[0], kAside[0], 1e-3);
}

TEST(LimitOfSpeed, DoesNotHoldAHandThatLeadsTheArm) {
  Rig rig(empty_scene());
  ToolSpeed tool(rig);
  rig.unit.set_tool_speed_limit(0.02);
  rig.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  for (int i = 0; i < 1000; ++i) {
    rig.world->push("gripper", {0, 15, 0}, rig.world->pose("tcp").position);
    rig.step();
  }
  EXPECT_GT(tool.fastest, 0.05);
}

}  // namespace
}  // namespace race::robot
