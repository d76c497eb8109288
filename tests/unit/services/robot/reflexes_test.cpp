// Each signal and each reaction on the real world: first the robot reacts, then it reports.
#include "services/robot/reflexes.h"

#include <array>

#include "tests/unit/services/robot/crash.h"

namespace race::robot {
namespace {

TEST(Collision, StopsTheArmAndAnswersWithTheReaction) {
  Crash crash;
  crash.run(usual_behavior(Mode::position));
  ASSERT_TRUE(crash.failure);
  EXPECT_EQ(crash.failure->code, "collision");
  EXPECT_EQ(crash.failure->reaction, "stop");
  ASSERT_FALSE(crash.incidents.empty());
  EXPECT_EQ(crash.incidents[0].signal, Signal::collision);
  EXPECT_TRUE(crash.incidents[0].contact.accidental);
  crash.rig.run(0.5);
  for (const double speed : crash.rig.world->dq()) EXPECT_LT(std::abs(speed), 0.02);
}

TEST(Collision, LetsTheTaskGoOn) {
  Crash crash;
  crash.run(usual_behavior(Mode::position));
  ASSERT_TRUE(crash.failure);
  const auto failure = crash.rig.move({.target = Offset{{0, -0.15, 0}}, .kind = MotionKind::linear});
  EXPECT_FALSE(failure) << failure->message;
}

TEST(Collision, MakesTheArmGiveWay) {
  Crash crash;
  crash.run(position_with({{.signal = Signal::collision, .reaction = Reaction::gravity_compensation}}));
  ASSERT_TRUE(crash.failure);
  EXPECT_EQ(crash.failure->code, "collision");
  EXPECT_EQ(crash.failure->reaction, "gravity_compensation");
  EXPECT_EQ(crash.rig.unit.behavior().operational.mode, Mode::gravity_compensation);
  crash.rig.run(2);
  EXPECT_LT(crash.force(), 1) << "it no longer presses";
  EXPECT_EQ(crash.rig.unit.move({.target = Offset{{0, -0.1, 0}}, .kind = MotionKind::linear}).error().code, "behavior");
  const auto failure =
      crash.rig.move({.target = Offset{{0, -0.1, 0}}, .kind = MotionKind::linear}, usual_behavior(Mode::position));
  EXPECT_FALSE(failure) << failure->message;
}

TEST(Collision, MakesTheArmGoBackAlongItsPathByTheDistance) {
  Crash crash;
  crash.run(position_with({{.signal = Signal::collision, .reaction = Reaction::retreat, .distance = 0.06}}));
  ASSERT_TRUE(crash.failure);
  EXPECT_EQ(crash.failure->code, "collision");
  EXPECT_EQ(crash.failure->reaction, "retreat");
  crash.rig.run(0.5);
  EXPECT_NEAR(crash.met - crash.tool(), 0.06, 0.015);
  const Vec3 start = Rig(empty_scene()).world->pose("tcp").position;
  EXPECT_NEAR(crash.rig.world->pose("tcp").position[0], start[0], 2e-3) << "on the path";
  EXPECT_EQ(crash.force(), 0);
  EXPECT_FALSE(crash.rig.move({.target = Offset{{0, -0.05, 0}}, .kind = MotionKind::linear}));
}

TEST(Collision, MayActBySeverity) {
  // Slow: light, which slows down only; fast: severe at once.
  const Behavior behavior = position_with(
      {{.signal = Signal::collision, .reaction = Reaction::stop},
       {.signal = Signal::collision, .reaction = Reaction::gravity_compensation, .severity = Severity::severe}});
  Crash slow;
  slow.speed = 0.1;
  slow.run(behavior);
  EXPECT_EQ(slow.failure->reaction, "stop");
  Crash fast;
  fast.speed = 1;
  fast.run(behavior);
  EXPECT_EQ(fast.failure->reaction, "gravity_compensation");
  EXPECT_EQ(fast.incidents[0].contact.severity, Severity::severe);
}

TEST(Collision, WithoutAReflexIsToldAllTheSame) {
  Crash crash;
  crash.run(position_with({}));
  ASSERT_TRUE(crash.failure);
  EXPECT_EQ(crash.failure->code, "following_error");
  ASSERT_FALSE(crash.incidents.empty());
  EXPECT_FALSE(crash.incidents[0].reflex);
}

bool above_threshold(const Joints& residual) {
  for (std::size_t j = 0; j < kJoints; ++j) {
    if (std::abs(residual[j]) > lwr_settings().contact_thresholds[j]) return true;
  }
  return false;
}

/// How far the command is from that of gravity compensation, computed here from the measured state, Nm.
double off_gravity_compensation(const Rig& rig) {
  const RobotState state = rig.unit.state();
  const Joints gravity = rig.unit.arm().gravity(state.q);
  double most = 0;
  for (std::size_t j = 0; j < kJoints; ++j) {
    const double torque = gravity[j] - lwr_settings().damping[j] * state.dq[j];
    most = std::max(most, std::abs(torque - rig.world->torques()[j]));
  }
  return most;
}

/// An arm with a reflex on collisions, and when it commanded something else than the one without a reflex, s.
struct Reacting {
  Rig rig{column_scene()};
  Reaction reaction;
  std::optional<double> changed{};
};

class Latency : public testing::TestWithParam<double> {};

// The same arm without a reflex runs beside them: both have the same contact and the same torques, to the last bit,
// until a reflex acts.
TEST_P(Latency, FromThresholdToChangedCommandIsAtMostTwoCyclesForEveryReaction) {
  const MoveCommand command{.target = Offset{{0, 0.5, 0}}, .kind = MotionKind::linear, .speed = GetParam()};
  Rig without(column_scene());
  ASSERT_TRUE(without.unit.move(command, position_with({})));
  std::array<Reacting, 4> arms{{{.reaction = Reaction::stop},
                                {.reaction = Reaction::gravity_compensation},
                                {.reaction = Reaction::retreat},
                                {.reaction = Reaction::slow_down}}};
  for (Reacting& arm : arms) {
    const Behavior behavior = position_with({{.signal = Signal::collision, .reaction = arm.reaction}});
    ASSERT_TRUE(arm.rig.unit.move(command, behavior));
  }
  std::optional<double> passed;
  const auto waits = [](const Reacting& arm) { return !arm.changed; };
  for (int i = 0; i < 20000 && std::any_of(arms.begin(), arms.end(), waits); ++i) {
    without.step();
    const double now = without.world->time();
    if (!passed && above_threshold(without.unit.state().tau_ext)) passed = now;
    for (Reacting& arm : arms) {
      if (arm.changed) continue;
      arm.rig.step();
      if (arm.rig.world->torques() != without.world->torques()) arm.changed = now;
    }
  }
  ASSERT_TRUE(passed);
  for (const Reacting& arm : arms) {
    SCOPED_TRACE(name(arm.reaction));
    ASSERT_TRUE(arm.changed) << "the reflex changes nothing";
    const double seconds = *arm.changed - *passed;
    RecordProperty(std::string(name(arm.reaction)), static_cast<int>(std::lround(seconds / ControlUnit::kPeriod)));
    EXPECT_GE(seconds, 0) << "the arms went apart before";
    EXPECT_LE(seconds, 2 * ControlUnit::kPeriod + 1e-9);
    if (arm.reaction == Reaction::gravity_compensation) {
      EXPECT_LT(off_gravity_compensation(arm.rig), 1e-9) << "it gives way at once";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, Latency, testing::Values(0.05, 0.1, 0.25, 0.5, 1.0));

TEST(ForceLimit, StopsAtTheForceAndNotBefore) {
  Rig rig(empty_scene());
  rig.unit.set_behavior(position_with({{.signal = Signal::force_limit, .reaction = Reaction::stop, .force = 20}}));
  double force = 0;
  rig.each_step = [&] { rig.world->push("gripper", {0, force, 0}, rig.world->pose("tcp").position); };
  force = 18;
  rig.run(1);
  for (const Incident& incident : rig.unit.take_incidents()) EXPECT_NE(incident.signal, Signal::force_limit);
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0, 0.1}}, .kind = MotionKind::linear, .speed = 0.2}));
  rig.run(0.2);
  EXPECT_TRUE(rig.unit.moving());
  force = 24;
  rig.run(0.3);
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome && *outcome);
  EXPECT_EQ((*outcome)->code, "force_limit");
}

TEST(VirtualWall, IsNotPassedAtFullSpeed) {
  Rig rig(empty_scene());
  const Reflex wall{.signal = Signal::virtual_wall, .wall = Plane{{0, 0.2, 0}, {0, -1, 0}}};
  double farthest = -1;
  rig.each_step = [&] { farthest = std::max(farthest, rig.world->pose("tcp").position[1]); };
  const auto failure = rig.move({.target = Joints{1.2, -0.35, 0, 1.6, 0, -1.19, 0}, .speed = 1, .acceleration = 1},
                                position_with({wall}));
  rig.run(0.5);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code, "virtual_wall");
  EXPECT_LT(farthest, 0.203);
  EXPECT_GT(farthest, 0.15) << "it stops at the wall, not far before";
  EXPECT_EQ(rig.move({.target = Offset{{0, 0.1, 0}}, .kind = MotionKind::linear})->code, "virtual_wall");
  EXPECT_FALSE(rig.move({.target = Offset{{0, -0.1, 0}}, .kind = MotionKind::linear})) << "back is allowed";
}

TEST(VirtualWall, OfABoxKeepsAHandFromLeadingTheArmIntoIt) {
  Rig rig(empty_scene());
  const Vec3 at = rig.world->pose("tcp").position;
  Behavior behavior = usual_behavior(Mode::gravity_compensation);
  behavior.reflexes.push_back(
      {.signal = Signal::virtual_wall, .wall = Box{{at[0] - 0.3, at[1] + 0.1, 0}, {at[0] + 0.3, at[1] + 0.5, 1}}});
  rig.unit.set_behavior(behavior);
  rig.each_step = [&] { rig.world->push("gripper", {0, 15, 0}, rig.world->pose("tcp").position); };
  rig.run(2);
  EXPECT_LT(rig.world->pose("tcp").position[1], at[1] + 0.11);
  EXPECT_EQ(rig.unit.behavior().operational.mode, Mode::position) << "stop: it holds";
}

TEST(JointLimit, StopsBeforeTheMargin) {
  Rig rig(empty_scene());
  const Reflex reflex{.signal = Signal::joint_limit, .margin = 0.2};
  Joints target{};
  target = {0, -0.35, 0, 1.6, 0, -2.05, 0};
  const auto failure = rig.move({.target = target, .speed = 1}, position_with({reflex}));
  rig.run(0.3);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code, "joint_limit");
  EXPECT_NEAR(rig.world->q()[5], rig.unit.arm().limits().lower[5] + 0.2, 0.02);
}

TEST(SlowDown, ScalesTheSpeedWhileASignalLastsAndKeepsThePath) {
  Rig rig(empty_scene());
  const Reflex reflex{.signal = Signal::contact, .reaction = Reaction::slow_down, .scale = 0.2};
  Vec3 force{};
  double off_line = 0;
  const Vec3 start = rig.world->pose("tcp").position;
  rig.each_step = [&] {
    rig.world->push("gripper", force, rig.world->pose("tcp").position);
    off_line = std::max(off_line, std::abs(rig.world->pose("tcp").position[2] - start[2]));
  };
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0.25, 0}}, .kind = MotionKind::linear, .speed = 0.3},
                            position_with({reflex})));
  rig.run(1);
  const auto speed = [&] {
    const double before = rig.world->pose("tcp").position[1];
    rig.run(0.05);
    return (rig.world->pose("tcp").position[1] - before) / 0.05;
  };
  const double full = speed();
  force = {0, -25, 0};
  rig.run(0.2);
  const double slow = speed();
  EXPECT_GT(full, 0.1);
  EXPECT_LT(slow, 0.35 * full);
  EXPECT_GT(slow, 0.05 * full);
  force = {};
  for (int i = 0; i < 20000 && rig.unit.moving(); ++i) rig.step();
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(*outcome) << "it arrives";
  EXPECT_LT(off_line, 2e-3);
}

TEST(Override, PausesOnThePathAndGoesOn) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0.25, 0}}, .kind = MotionKind::linear, .speed = 0.3}));
  rig.run(0.7);
  rig.unit.set_override(0);
  rig.run(0.3);
  const Vec3 paused = rig.world->pose("tcp").position;
  rig.run(3);
  EXPECT_LT(distance(rig.world->pose("tcp").position, paused), 1e-4);
  EXPECT_TRUE(rig.unit.moving());
  rig.unit.set_override(0.5);
  for (int i = 0; i < 20000 && rig.unit.moving(); ++i) rig.step();
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(*outcome);
  EXPECT_GT(rig.world->pose("tcp").position[1], paused[1] + 0.05);
}

TEST(Override, HalvesTheSpeed) {
  const auto seconds = [](double share) {
    Rig rig(empty_scene());
    rig.unit.set_override(share);
    rig.move({.target = Offset{{0, 0.2, 0}}, .kind = MotionKind::linear});
    return rig.world->time();
  };
  EXPECT_NEAR(seconds(0.5), 2 * seconds(1), 0.05 * seconds(0.5));
}

TEST(SpeedLimit, OfTheBehaviorIsKeptByTheTool) {
  Rig rig(empty_scene());
  Behavior behavior = usual_behavior(Mode::position);
  behavior.operational.speed = 0.1;
  double fastest = 0;
  Vec3 before = rig.world->pose("tcp").position;
  rig.each_step = [&] {
    const Vec3 now = rig.world->pose("tcp").position;
    fastest = std::max(fastest, distance(now, before) / ControlUnit::kPeriod);
    before = now;
  };
  ASSERT_FALSE(rig.move({.target = Joints{0.5, -0.2, 0.2, 1.4, 0, -1, 0}, .speed = 1, .acceleration = 1}, behavior));
  EXPECT_LT(fastest, 0.102);
  EXPECT_GT(fastest, 0.095);
}

}  // namespace
}  // namespace race::robot
