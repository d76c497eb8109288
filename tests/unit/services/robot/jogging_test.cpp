// Manual motion while a person holds a button: how it begins and ends, what bounds it, and what interrupts it.
#include <random>

#include "tests/unit/services/robot/crash.h"

namespace race::robot {
namespace {

JogVelocity joint(std::size_t number, double speed) {
  Joints speeds{};
  speeds[number - 1] = speed;
  return speeds;
}

JogVelocity tool(const Vec3& linear, const Vec3& angular = {}, ToolVelocity::Axes axes = ToolVelocity::Axes::o) {
  return ToolVelocity{linear, angular, axes};
}

/// A person who holds a button: a call each 50 ms. The last refusal.
std::optional<Refusal> hold(Rig& rig, const JogVelocity& wanted, double seconds) {
  std::optional<Refusal> refused;
  for (int i = 0; i < std::lround(seconds * 20); ++i) {
    const auto accepted = rig.unit.jog(wanted);
    if (!accepted) refused = accepted.error();
    rig.run(0.05);
  }
  return refused;
}

double largest(const Joints& speeds) {
  double most = 0;
  for (const double speed : speeds) most = std::max(most, std::abs(speed));
  return most;
}

/// Cycles until the arm is slower than now; 1: the command of the next cycle slows it down already, which the arm has
/// followed when the cycle after that measures it.
int cycles_to_slow_down(Rig& rig) {
  const double speed = largest(rig.world->dq());
  for (int cycle = 0; cycle < 1000; ++cycle) {
    rig.step();
    if (largest(rig.world->dq()) < speed - 1e-3) return cycle;
  }
  return 1000;
}

TEST(Jog, KeepsTheWantedSpeedWhileTheButtonIsHeld) {
  Rig rig(empty_scene());
  ASSERT_FALSE(hold(rig, joint(1, 0.5), 0.5));
  double slowest = 1;
  rig.each_step = [&] { slowest = std::min(slowest, rig.world->dq()[0]); };
  ASSERT_FALSE(hold(rig, joint(1, 0.5), 1));
  EXPECT_NEAR(slowest, 0.5, 0.001);
}

TEST(Jog, SlowsDownInTheCycleAfterTheHoldOfTheLastCall) {
  Rig rig(empty_scene());
  hold(rig, joint(1, 0.5), 1);
  ASSERT_TRUE(rig.unit.jog(joint(1, 0.5)));
  EXPECT_EQ(cycles_to_slow_down(rig), kHoldCycles + 1);
}

TEST(Jog, SlowsDownInTheCycleAfterAStop) {
  Rig rig(empty_scene());
  hold(rig, joint(1, 0.5), 1);
  rig.unit.stop();
  EXPECT_EQ(cycles_to_slow_down(rig), 1);
  EXPECT_FALSE(rig.unit.moving());
}

TEST(Jog, SlowsDownInTheCycleAfterZeroIsWanted) {
  Rig rig(empty_scene());
  hold(rig, joint(1, 0.5), 1);
  ASSERT_TRUE(rig.unit.jog(Joints{}));
  EXPECT_EQ(cycles_to_slow_down(rig), 1);
}

TEST(Jog, StandsSoonAsTheReadmeSays) {
  for (const bool stop : {false, true}) {
    Rig rig(empty_scene());
    hold(rig, tool({0, 0.25, 0}), 1);
    ASSERT_NEAR(tool_way(rig.unit.arm(), rig.world->q(), rig.world->dq()), 0.25, 1e-3);
    if (stop)
      rig.unit.stop();
    else
      ASSERT_TRUE(rig.unit.jog(tool({})));
    const auto [time, way] = standstill(rig);
    EXPECT_NEAR(time, stop ? 0.058 : 0.080, 0.008);
    EXPECT_NEAR(way, 0.006, 0.001);
  }
}

TEST(Jog, EndsWhenTheArmStandsAndHoldsThere) {
  Rig rig(empty_scene());
  hold(rig, tool({0, 0.25, 0}), 1);
  rig.run(0.2);
  EXPECT_TRUE(rig.unit.moving());
  rig.run(0.1);
  EXPECT_FALSE(rig.unit.moving());
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(*outcome) << "as wanted";
  rig.run(0.1);
  const Joints held = rig.world->q();
  rig.run(2);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], held[i], 1e-4);
  EXPECT_FALSE(rig.move({.target = down_at(0.5, 0.2, 0.3)})) << "the next move begins where it holds";
}

TEST(Jog, SpeedsUpAndSlowsDownWithBoundedAcceleration) {
  Rig rig(empty_scene());
  const ControlSettings settings = lwr_settings();
  Joints up{}, down{};
  rig.each_step = [&, before = Joints{}]() mutable {
    for (std::size_t i = 0; i < kJoints; ++i) {
      const double now = std::abs(rig.world->dq()[i]);
      up[i] = std::max(up[i], (now - before[i]) / ControlUnit::kPeriod);
      down[i] = std::max(down[i], (before[i] - now) / ControlUnit::kPeriod);
      before[i] = now;
    }
  };
  const Joints wanted = {0.5, 0.4, -0.5, -0.5, 1, 0.8, -1};
  Joints back = wanted;
  for (double& speed : back) speed = -speed;
  ASSERT_FALSE(hold(rig, wanted, 0.5));
  ASSERT_FALSE(hold(rig, back, 0.5));
  rig.run(0.5);
  for (std::size_t i = 0; i < kJoints; ++i) {
    EXPECT_LT(up[i], 0.5 * settings.planner.acceleration[i] * 1.15) << "joint " << i + 1;
    EXPECT_LT(down[i], settings.braking[i] * 1.05) << "joint " << i + 1;
  }
}

TEST(Jog, MovesTheToolStraightAlongTheWorldAndKeepsItsOrientation) {
  for (const Vec3& way : {Vec3{0.2, 0, 0}, Vec3{0, -0.25, 0}, Vec3{0.1, 0.1, -0.1}}) {
    Rig rig(empty_scene());
    ASSERT_FALSE(rig.move({.target = down_at(0.45, 0, 0.35)}));
    const Pose from = rig.world->pose("tcp");
    ASSERT_FALSE(hold(rig, tool(way), 0.6));
    rig.run(0.5);
    const Pose to = rig.world->pose("tcp");
    const double speed = std::hypot(way[0], way[1], way[2]);
    const double length = distance(from.position, to.position);
    EXPECT_GT(length, 0.6 * speed);
    EXPECT_LT(length, (0.6 + ControlUnit::kJogHold) * speed);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(to.position[i] - from.position[i], way[i] / speed * length, 1e-3);
    EXPECT_LT(angle(from, to), 0.004);
  }
}

TEST(Jog, MovesAlongTheAxesOfTheTool) {
  Rig rig(empty_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.45, 0, 0.35)}));
  const Vec3 from = rig.world->pose("tcp").position;
  ASSERT_FALSE(hold(rig, tool({0, 0.1, 0.1}, {}, ToolVelocity::Axes::tool), 0.5));
  rig.run(0.5);
  const Vec3 to = rig.world->pose("tcp").position;
  EXPECT_LT(to[2], from[2] - 0.05) << "the tool points down";
  EXPECT_LT(to[1], from[1] - 0.05) << "and is turned half a turn around x";
  EXPECT_NEAR(to[2] - from[2], to[1] - from[1], 1e-3);
  EXPECT_NEAR(to[0], from[0], 1e-3);
}

TEST(Jog, TurnsTheToolAroundItsCentrePoint) {
  Rig rig(empty_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.45, 0, 0.35)}));
  const Pose from = rig.world->pose("tcp");
  ASSERT_FALSE(hold(rig, tool({}, {0, 0, 0.5}), 1));
  rig.run(0.5);
  EXPECT_GT(angle(from, rig.world->pose("tcp")), 0.5);
  EXPECT_LT(distance(rig.world->pose("tcp").position, from.position), 2e-3);
}

TEST(Jog, StopsAJointBeforeItsLimitAndNoOther) {
  Rig rig(empty_scene());
  const JointLimits& limits = rig.unit.arm().limits();
  double nearest = 1;
  rig.each_step = [&] { nearest = std::min(nearest, limits.upper[5] - rig.world->q()[5]); };
  ASSERT_FALSE(hold(rig, Joints{0.1, 0, 0, 0, 0, 1.2, 0}, 4));
  EXPECT_GT(nearest, 0.009);
  EXPECT_LT(nearest, 0.02) << "it comes close";
  EXPECT_NEAR(rig.world->dq()[0], 0.1, 1e-3);
  EXPECT_NEAR(rig.world->dq()[5], 0, 1e-3);
  ASSERT_FALSE(hold(rig, joint(6, -0.5), 0.5));
  EXPECT_NEAR(rig.world->dq()[5], -0.5, 1e-2) << "leaving is allowed";
}

TEST(Jog, KeepsClearOfALimitAlsoWhenAnotherJointTurnsRound) {
  Rig rig(empty_scene());
  const JointLimits& limits = rig.unit.arm().limits();
  double nearest = 1;
  rig.each_step = [&] { nearest = std::min(nearest, limits.upper[5] - rig.world->q()[5]); };
  bool forth = true;
  for (int i = 0; i < 80; ++i, forth = !forth) {
    ASSERT_TRUE(rig.unit.jog(Joints{forth ? 0.9 : -0.9, 0, 0, 0, 0, 1.5, forth ? -1.5 : 1.5}));
    rig.run(0.04);
  }
  EXPECT_GT(nearest, 0.009);
  EXPECT_LT(nearest, 0.05);
}

TEST(Jog, StopsTheWholeMotionOfTheToolBeforeALimitAndLeavesIt) {
  Rig rig(empty_scene());
  ASSERT_FALSE(rig.move({.target = Joints{0, -0.35, 0, 1.6, 0, -1.8, 0}}));
  const JointLimits& limits = rig.unit.arm().limits();
  double nearest = 1;
  rig.each_step = [&] {
    for (std::size_t i = 0; i < kJoints; ++i)
      nearest = std::min({nearest, limits.upper[i] - rig.world->q()[i], rig.world->q()[i] - limits.lower[i]});
  };
  const Vec3 turning{0, 1, 0};
  ASSERT_FALSE(hold(rig, tool({}, turning), 4));
  ASSERT_LT(largest(rig.world->dq()), 1e-3) << "it has come to the limit and stands";
  EXPECT_GT(nearest, 0.009);
  EXPECT_LT(nearest, 0.02);
  ASSERT_FALSE(hold(rig, tool({}, {0, -0.5, 0}), 0.5));
  EXPECT_GT(largest(rig.world->dq()), 0.1);
}

/// The largest share of its speed limit that a joint has, and the nearest that one comes to its limit [rad].
struct Bounds {
  explicit Bounds(Rig& rig) {
    rig.each_step = [this, &rig] {
      const JointLimits& limits = rig.unit.arm().limits();
      for (std::size_t i = 0; i < kJoints; ++i) {
        fastest = std::max(fastest, std::abs(rig.world->dq()[i]) / limits.velocity[i]);
        nearest = std::min({nearest, limits.upper[i] - rig.world->q()[i], rig.world->q()[i] - limits.lower[i]});
      }
    };
  }
  double fastest = 0;
  double nearest = 1;
};

TEST(Jog, SlowsDownNearASingularityInsteadOfRacingJoints) {
  for (const Vec3& way : {Vec3{0.25, 0, 0}, Vec3{0, 0, 0.25}, Vec3{-0.25, 0, 0}, Vec3{0, 0.25, 0}}) {
    Rig rig(empty_scene());
    Bounds bounds(rig);
    ASSERT_FALSE(hold(rig, tool(way), 5)) << "up to the stretched arm, or through its shoulder";
    EXPECT_LT(bounds.fastest, 0.51);
    EXPECT_GT(bounds.nearest, 0.009);
  }
}

TEST(Jog, StretchesTheArmAndComesBackFromItsSingularity) {
  Rig rig(empty_scene());
  ASSERT_FALSE(hold(rig, tool({0.25, 0, 0}), 5));
  const Vec3 stretched = rig.world->pose("tcp").position;
  EXPECT_LT(tool_way(rig.unit.arm(), rig.world->q(), rig.world->dq()), 0.05) << "there is hardly a further way";
  ASSERT_FALSE(hold(rig, tool({-0.2, 0, 0}), 2));
  EXPECT_LT(rig.world->pose("tcp").position[0], stretched[0] - 0.1);
}

TEST(Jog, SlidesAlongTheEdgeOfItsReach) {
  Rig rig(empty_scene());
  ASSERT_FALSE(hold(rig, tool({0.25, 0, 0}), 5));
  const Vec3 from = rig.world->pose("tcp").position;
  ASSERT_FALSE(hold(rig, tool({0.15, 0.15, 0}), 2));
  EXPECT_GT(rig.world->pose("tcp").position[1], from[1] + 0.1) << "the way out alone is closed";
}

TEST(Jog, KeepsItsBoundsWhateverIsWanted) {
  constexpr unsigned seed = 11;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const auto number = [&](double most) { return std::uniform_real_distribution(-most, most)(random); };
  Rig rig(empty_scene());
  rig.unit.set_behavior(position_with({}));
  Bounds bounds(rig);
  for (int i = 0; i < 250; ++i) {
    JogVelocity wanted = tool({number(0.14), number(0.14), number(0.14)}, {number(0.5), number(0.5), number(0.5)},
                              i % 3 == 0 ? ToolVelocity::Axes::tool : ToolVelocity::Axes::o);
    if (i % 4 == 0)
      wanted = Joints{number(0.9), number(0.9), number(1), number(1), number(1.7), number(1.5), number(1)};
    ASSERT_FALSE(hold(rig, wanted, 0.2));
    ASSERT_LT(bounds.fastest, 0.52) << "case " << i;
    ASSERT_GT(bounds.nearest, 0.005) << "case " << i;
  }
}

struct TooMuch {
  const char* name;
  JogVelocity wanted;
  const char* argument;
};

class JogRefusals : public testing::TestWithParam<TooMuch> {};

TEST_P(JogRefusals, NeverMoveTheArm) {
  Rig rig(empty_scene());
  rig.run(0.1);
  const Joints before = rig.world->q();
  const auto accepted = rig.unit.jog(GetParam().wanted);
  ASSERT_FALSE(accepted);
  EXPECT_EQ(accepted.error().code, "out_of_range");
  EXPECT_EQ(accepted.error().argument, GetParam().argument);
  EXPECT_FALSE(rig.unit.moving());
  rig.run(0.5);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], before[i], 1e-6);
}

TEST_P(JogRefusals, DoNotKeepAMotionUp) {
  Rig rig(empty_scene());
  hold(rig, joint(1, 0.3), 0.5);
  hold(rig, GetParam().wanted, 0.5);
  EXPECT_LT(std::abs(rig.world->dq()[0]), 1e-3) << "the hold of the last good call is over";
}

INSTANTIATE_TEST_SUITE_P(Jog, JogRefusals,
                         testing::Values(TooMuch{"JointTooFast", joint(1, 0.97), "joints"},
                                         TooMuch{"JointTooFastBackwards", joint(7, -1.61), "joints"},
                                         TooMuch{"JointNotANumber", joint(3, NAN), "joints"},
                                         TooMuch{"JointInfinite", joint(3, -INFINITY), "joints"},
                                         TooMuch{"ToolTooFast", tool({0.2, 0.2, 0}), "linear"},
                                         TooMuch{"ToolNotANumber", tool({0, NAN, 0}), "linear"},
                                         TooMuch{"ToolInfinite", tool({INFINITY, 0, 0}), "linear"},
                                         TooMuch{"TurningTooFast", tool({}, {0, 0, 1.01}), "angular"},
                                         TooMuch{"TurningNotANumber", tool({}, {NAN, 0, 0}), "angular"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Jog, IsRefusedWhileItMovesOrIsLedByHand) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = down_at(0.5, 0.2, 0.2)}));
  EXPECT_EQ(rig.unit.jog(joint(1, 0.1)).error().code, "busy");
  rig.unit.stop();
  rig.run(0.5);
  ASSERT_TRUE(rig.unit.jog(joint(1, 0.1)));
  EXPECT_EQ(rig.unit.move({.target = down_at(0.5, 0.2, 0.2)}).error().code, "busy");
  rig.unit.stop();
  rig.run(0.5);
  rig.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  EXPECT_EQ(rig.unit.jog(joint(1, 0.1)).error().code, "behavior");
}

class JogInMode : public testing::TestWithParam<Mode> {};

TEST_P(JogInMode, FollowsAndStands) {
  Rig rig(empty_scene());
  rig.unit.set_behavior(usual_behavior(GetParam()));
  rig.run(0.3);
  const Vec3 from = rig.world->pose("tcp").position;
  ASSERT_FALSE(hold(rig, tool({0, 0.2, 0}), 1));
  EXPECT_NEAR(rig.world->pose("tcp").position[1], from[1] + 0.19, 0.02);
  rig.run(1.5);
  EXPECT_FALSE(rig.unit.moving());
  EXPECT_EQ(rig.unit.behavior().operational.mode, GetParam());
  EXPECT_LT(largest(rig.world->dq()), 0.01);
}

TEST_P(JogInMode, EndsAtACollisionAndBeginsAnewOnceThePersonHasLetGo) {
  Rig rig(column_scene());
  rig.unit.set_behavior(usual_behavior(GetParam()));
  rig.run(0.3);
  const JogVelocity into = tool({0, 0.2, 0});
  const auto refused = hold(rig, into, 3);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->code, "collision");
  EXPECT_EQ(refused->reaction, "stop");
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome && *outcome);
  EXPECT_EQ((*outcome)->code, "collision");
  EXPECT_FALSE(rig.unit.moving());
  EXPECT_LT(largest(rig.world->dq()), 0.01) << "it stands, though the button is held";
  EXPECT_EQ(rig.unit.jog(tool({0, -0.1, 0})).error().code, "collision") << "away from it, too";
  rig.run(ControlUnit::kJogHold - 0.005);
  EXPECT_EQ(rig.unit.jog(into).error().code, "collision");
  rig.run(ControlUnit::kJogHold + 0.005);
  const double there = rig.world->pose("tcp").position[1];
  ASSERT_FALSE(hold(rig, tool({0, -0.1, 0}), 0.5));
  EXPECT_LT(rig.world->pose("tcp").position[1], there - 0.03);
}

INSTANTIATE_TEST_SUITE_P(Jog, JogInMode,
                         testing::Values(Mode::position, Mode::joint_impedance, Mode::cartesian_impedance),
                         [](const auto& info) { return std::string(name(info.param)); });

TEST(Jog, ReactsToACollisionInTheSameCycle) {
  Rig rig(column_scene());
  bool moves = true;
  rig.each_step = [&] {
    for (const Incident& incident : rig.unit.take_incidents())
      if (incident.signal == Signal::collision) moves = rig.unit.moving();
  };
  hold(rig, tool({0, 0.2, 0}), 2);
  EXPECT_FALSE(moves);
}

TEST(Jog, EndsWhenSomethingHoldsTheArmBack) {
  Rig rig(column_scene());
  rig.unit.set_behavior(position_with({}));
  const auto refused = hold(rig, tool({0, 0.1, 0}), 5);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->code, "following_error");
}

TEST(Jog, StopsBeforeAVirtualWall) {
  Rig rig(empty_scene());
  const double wall = rig.world->pose("tcp").position[1] + 0.15;
  rig.unit.set_behavior(position_with({{.signal = Signal::virtual_wall, .wall = Plane{{0, wall, 0}, {0, -1, 0}}}}));
  const auto refused = hold(rig, tool({0, 0.25, 0}), 2);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->code, "virtual_wall");
  EXPECT_LT(rig.world->pose("tcp").position[1], wall);
  rig.run(0.3);
  EXPECT_FALSE(hold(rig, tool({0, -0.25, 0}), 0.3)) << "leaving is allowed";
}

TEST(Jog, RetreatsNowhereAsItHasNoPath) {
  Rig rig(column_scene());
  ASSERT_FALSE(rig.move({.target = Offset{{0, 0.05, 0}}, .kind = MotionKind::linear}));
  rig.unit.set_behavior(position_with({{.signal = Signal::collision, .reaction = Reaction::retreat}}));
  rig.unit.take_incidents();
  for (int i = 0; i < 3000 && rig.unit.take_incidents().empty(); ++i) {
    ASSERT_TRUE(rig.unit.jog(tool({0, 0.15, 0})));
    rig.step();
  }
  EXPECT_EQ(rig.unit.jog(tool({0, 0.15, 0})).error().code, "collision");
  const double there = rig.world->pose("tcp").position[1];
  rig.run(1);
  EXPECT_NEAR(rig.world->pose("tcp").position[1], there, 0.005) << "the path of the move before is none of the jog";
}

TEST(Jog, IsScaledByTheOverride) {
  Rig rig(empty_scene());
  rig.unit.set_override(0.5);
  ASSERT_FALSE(hold(rig, joint(1, 0.4), 1));
  EXPECT_NEAR(rig.world->dq()[0], 0.2, 1e-3);
  rig.unit.set_override(0);
  ASSERT_FALSE(hold(rig, joint(1, 0.4), 1));
  EXPECT_NEAR(rig.world->dq()[0], 0, 1e-3);
}

}  // namespace
}  // namespace race::robot
