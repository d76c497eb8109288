// Hand guiding while a person holds a button: the arm follows a hand, and brakes and holds when the button is let go
// of.
#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/unit/services/robot/crash.h"

namespace race::robot {
namespace {

/// A hand that pulls the tool from now on [N].
void pull(Rig& rig, const Vec3& force) {
  rig.each_step = [&rig, force] { rig.world->push("gripper", force, rig.world->pose("tcp").position); };
}

constexpr double kGain = 200;  // Ns/m, of a hand that leads
constexpr double kMost = 30;   // N

/// A hand that leads the tool along y with this speed from now on [m/s].
void lead(Rig& rig, double wanted) {
  rig.each_step = [&rig, wanted, before = rig.world->pose("tcp").position[1]]() mutable {
    const Vec3 now = rig.world->pose("tcp").position;
    const double force = kGain * (wanted - (now[1] - std::exchange(before, now[1])) / ControlUnit::kPeriod);
    rig.world->push("gripper", {0, std::clamp(force, -kMost, kMost), 0}, now);
  };
}

/// A person who holds a button: a call each 50 ms. The last refusal.
std::optional<Refusal> hold(Rig& rig, double seconds) {
  std::optional<Refusal> refused;
  for (int i = 0; i < std::lround(seconds * 20); ++i) {
    if (const auto accepted = rig.unit.guide(); !accepted) refused = accepted.error();
    rig.run(0.05);
  }
  return refused;
}

double speed(Rig& rig) { return tool_way(rig.unit.arm(), rig.world->q(), rig.world->dq()); }

bool stands(Rig& rig) {
  return std::ranges::all_of(rig.world->dq(), [](double dq) { return std::abs(dq) < 0.01; });
}

Mode mode(const Rig& rig) { return rig.unit.behavior().operational.mode; }

TEST(Guide, FollowsAHandThatWouldBeACollisionElse) {
  Rig rig(empty_scene());
  ASSERT_FALSE(hold(rig, 0.3));
  const double from = rig.world->pose("tcp").position[1];
  pull(rig, {0, 25, 0});
  ASSERT_FALSE(hold(rig, 1));
  EXPECT_GT(rig.world->pose("tcp").position[1], from + 0.1);
  EXPECT_EQ(mode(rig), Mode::gravity_compensation);
  const auto incidents = rig.unit.take_incidents();
  ASSERT_FALSE(incidents.empty()) << "it is felt";
  for (const Incident& incident : incidents) EXPECT_FALSE(incident.reflex) << "and nothing reacts";
}

TEST(Guide, StaysWhereItIsWithoutAHand) {
  Rig rig(empty_scene());
  rig.run(0.1);
  const Vec3 from = rig.world->pose("tcp").position;
  ASSERT_FALSE(hold(rig, 2));
  EXPECT_LT(distance(rig.world->pose("tcp").position, from), 1e-3);
}

TEST(Guide, GivesWayUntilTheHoldOfTheLastCallIsOver) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.guide());
  for (int cycle = 0; cycle < kHoldCycles; ++cycle) rig.step();
  EXPECT_EQ(mode(rig), Mode::gravity_compensation);
  rig.step();
  EXPECT_EQ(mode(rig), Mode::position);
}

class GuideIn : public testing::TestWithParam<Mode> {};

TEST_P(GuideIn, ThenBrakesAndHoldsAsBefore) {
  Rig rig(empty_scene());
  Behavior behavior = usual_behavior(GetParam());
  behavior.operational.speed = 0.4;
  rig.unit.set_behavior(behavior);
  rig.run(0.3);
  lead(rig, 0.2);
  ASSERT_FALSE(hold(rig, 0.5));
  rig.run(ControlUnit::kJogHold - 0.05);
  EXPECT_NEAR(speed(rig), 0.2, 0.02);
  EXPECT_TRUE(rig.unit.moving());
  rig.each_step = {};
  rig.run(0.15);
  EXPECT_LT(speed(rig), 0.01);
  rig.run(1);
  EXPECT_FALSE(rig.unit.moving());
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(*outcome) << "as wanted";
  EXPECT_EQ(rig.unit.behavior(), behavior);
  const Vec3 held = rig.world->pose("tcp").position;
  rig.run(2);
  EXPECT_LT(distance(rig.world->pose("tcp").position, held), 2e-4) << "it does not sag";
}

INSTANTIATE_TEST_SUITE_P(Guide, GuideIn,
                         testing::Values(Mode::position, Mode::joint_impedance, Mode::cartesian_impedance),
                         [](const auto& info) { return std::string(name(info.param)); });

TEST(Guide, StandsSoonAsTheReadmeSays) {
  for (const bool stop : {false, true}) {
    Rig rig(empty_scene());
    lead(rig, 0.25);
    ASSERT_FALSE(hold(rig, 1));
    ASSERT_NEAR(speed(rig), 0.25, 0.02);
    if (stop) rig.unit.stop();
    for (int i = 0; i < kHoldCycles && mode(rig) == Mode::gravity_compensation; ++i) rig.step();
    ASSERT_NE(mode(rig), Mode::gravity_compensation);
    rig.each_step = {};
    const auto [time, way] = standstill(rig);
    EXPECT_NEAR(time, stop ? 0.042 : 0.068, 0.01);
    EXPECT_NEAR(way, 0.003, 0.001);
  }
}

TEST(Guide, GoesOnWhenTheButtonIsPressedAgainWhileItBrakes) {
  Rig rig(empty_scene());
  pull(rig, {0, 20, 0});
  ASSERT_FALSE(hold(rig, 0.5));
  rig.run(ControlUnit::kJogHold - 0.05 + 0.01);
  ASSERT_EQ(mode(rig), Mode::position);
  ASSERT_TRUE(rig.unit.moving());
  const double there = rig.world->pose("tcp").position[1];
  ASSERT_FALSE(hold(rig, 0.5));
  EXPECT_GT(rig.world->pose("tcp").position[1], there + 0.02);
  EXPECT_FALSE(rig.unit.take_outcome());
}

TEST(Guide, HoldsThoughTheHandStillPulls) {
  Rig rig(empty_scene());
  pull(rig, {0, 40, 0});
  hold(rig, 0.3);
  rig.run(1);
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(*outcome) << (*outcome)->code;
  EXPECT_TRUE(stands(rig));
}

TEST(Guide, EndsAtOnceByAStopAndHolds) {
  Rig rig(empty_scene());
  const Behavior behavior = position_with({{.signal = Signal::collision, .severity = Severity::medium}});
  rig.unit.set_behavior(behavior);
  lead(rig, 0.25);
  hold(rig, 0.5);
  rig.unit.stop();
  EXPECT_FALSE(rig.unit.moving());
  EXPECT_EQ(rig.unit.behavior(), behavior) << "as a stop leaves the one from before";
  rig.each_step = {};
  rig.run(0.2);
  EXPECT_TRUE(stands(rig));
  EXPECT_FALSE(rig.unit.take_outcome());
}

TEST(Guide, IsRefusedWhileItMovesAndWhereNothingWouldBrakeIt) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = down_at(0.5, 0.2, 0.2)}));
  EXPECT_EQ(rig.unit.guide().error().code, "busy");
  rig.unit.stop();
  rig.run(0.5);
  ASSERT_TRUE(rig.unit.jog(Joints{0.1, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(rig.unit.guide().error().code, "busy");
  rig.unit.stop();
  rig.run(0.5);
  ASSERT_TRUE(rig.unit.guide());
  EXPECT_EQ(rig.unit.move({.target = down_at(0.5, 0.2, 0.2)}).error().code, "behavior");
  EXPECT_EQ(rig.unit.jog(Joints{}).error().code, "behavior");
  rig.unit.stop();
  rig.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  EXPECT_EQ(rig.unit.guide().error().code, "behavior");
}

TEST(Guide, StopsAtAVirtualWallUntilTheButtonIsLetGoOf) {
  Rig rig(empty_scene());
  const double wall = rig.world->pose("tcp").position[1] + 0.08;
  const Behavior behavior = position_with(
      {{.signal = Signal::collision}, {.signal = Signal::virtual_wall, .wall = Plane{{0, wall, 0}, {0, -1, 0}}}});
  rig.unit.set_behavior(behavior);
  rig.run(0.3);
  lead(rig, 0.1);
  for (int i = 0; i < 2000 && rig.unit.guide(); ++i) rig.step();
  rig.each_step = {};
  const auto refused = hold(rig, 0.5);
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->code, "virtual_wall");
  EXPECT_EQ(refused->reaction, "stop");
  EXPECT_LT(rig.world->pose("tcp").position[1], wall);
  EXPECT_TRUE(stands(rig)) << "though the button is held";
  EXPECT_EQ(rig.unit.behavior(), behavior);
  EXPECT_EQ(rig.unit.jog(Joints{}).error().code, "virtual_wall") << "it is the same button";
  rig.run(ControlUnit::kJogHold + 0.01);
  const double there = rig.world->pose("tcp").position[1];
  pull(rig, {0, -15, 0});
  EXPECT_FALSE(hold(rig, 0.5)) << "leaving is allowed";
  EXPECT_LT(rig.world->pose("tcp").position[1], there - 0.02);
}

TEST(Guide, GivesWayFurtherWhereAReflexWouldGiveWay) {
  Rig rig(empty_scene());
  const double wall = rig.world->pose("tcp").position[1] + 0.05;
  rig.unit.set_behavior(position_with({{.signal = Signal::virtual_wall,
                                        .reaction = Reaction::gravity_compensation,
                                        .wall = Plane{{0, wall, 0}, {0, -1, 0}}}}));
  lead(rig, 0.1);
  ASSERT_FALSE(hold(rig, 1));
  EXPECT_GT(rig.world->pose("tcp").position[1], wall);
  EXPECT_FALSE(rig.unit.take_incidents().empty()) << "it is told";
}

TEST(Guide, SinksUnderACarriedWeightAsTheReadmeSays) {
  Rig rig(empty_scene());
  ASSERT_FALSE(hold(rig, 0.3));
  pull(rig, {0, 0, -0.3 * 9.81});
  const double from = rig.world->pose("tcp").position[2];
  ASSERT_FALSE(hold(rig, 0.5));
  EXPECT_NEAR(from - rig.world->pose("tcp").position[2], 0.055, 0.02);
  ASSERT_FALSE(hold(rig, 0.5));
  EXPECT_NEAR(from - rig.world->pose("tcp").position[2], 0.18, 0.02);
  rig.run(0.5);
  const double held = rig.world->pose("tcp").position[2];
  rig.run(1);
  EXPECT_NEAR(rig.world->pose("tcp").position[2], held, 1e-4) << "the button is let go of";
}

}  // namespace
}  // namespace race::robot
