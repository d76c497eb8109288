// What a stop, or a reflex that ends leading by hand, leaves of a behavior: the next move, without one of its own, must
// not run into a person with reflexes that were meant for another mode.
#include "tests/unit/services/robot/crash.h"

namespace race::robot {
namespace {

/// A way to position control that no behavior was given for.
struct Way {
  const char* name;
  Behavior behavior;
  double push;  // N sideways, until a reflex changes the mode; 0: none
  bool stop;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

Reflex on_collision(Reaction reaction, Severity severity = Severity::light) {
  return {.signal = Signal::collision, .reaction = reaction, .severity = severity};
}

void go(const Way& way, Rig& rig) {
  rig.unit.set_behavior(way.behavior);
  rig.run(0.3);
  const auto mode = [&] { return rig.unit.behavior().operational.mode; };
  for (int i = 0; way.push > 0 && i < 100 && mode() == way.behavior.operational.mode; ++i) {
    rig.world->push("gripper", {0, way.push, 0}, rig.world->pose("tcp").position);
    rig.step();
  }
  EXPECT_EQ(mode() != way.behavior.operational.mode, way.push > 0);
  if (way.stop) rig.unit.stop();
  rig.run(1);
  rig.unit.take_incidents();
}

class LeftWithoutABehavior : public testing::TestWithParam<Way> {};

TEST_P(LeftWithoutABehavior, StopsTheNextMoveAtTheFirstCollision) {
  Crash crash;
  const Joints start = crash.rig.world->q();
  go(GetParam(), crash.rig);
  ASSERT_EQ(crash.rig.unit.behavior().operational.mode, Mode::position);
  const auto astray = crash.rig.move({.target = start});
  ASSERT_FALSE(astray) << "on the way back from where it was led: " << astray->message;
  crash.speed = 0.2;
  crash.run();
  ASSERT_TRUE(crash.failure);
  EXPECT_EQ(crash.failure->code, "collision");
  EXPECT_EQ(crash.failure->reaction, "stop");
  crash.rig.run(2);
  EXPECT_LT(crash.force(), 40) << "it no longer pushes";
}

TEST_P(LeftWithoutABehavior, DoesNotMoveByItself) {
  Rig rig(empty_scene());
  go(GetParam(), rig);
  const Vec3 there = rig.world->pose("tcp").position;
  rig.run(1);
  EXPECT_LT(distance(rig.world->pose("tcp").position, there), 1e-4);
}

const Way kWays[] = {
    {"StoppedWhileLedByHand", usual_behavior(Mode::gravity_compensation), 0, true},
    {"StoppedWhileLedByHandAsItSlowsDown",
     behavior_with(Mode::gravity_compensation, {on_collision(Reaction::slow_down)}), 0, true},
    {"StoppedAfterItGaveWay", position_with({on_collision(Reaction::gravity_compensation)}), 60, true},
    {"StoppedAfterItGaveWayToWhatIsSevere",
     position_with({on_collision(Reaction::gravity_compensation, Severity::severe)}), 150, true},
    {"StoppedByAHandThatLedIt",
     behavior_with(Mode::gravity_compensation, {on_collision(Reaction::stop, Severity::severe)}), 150, false},
    {"RetreatedFromAHandThatLedIt", behavior_with(Mode::gravity_compensation, {on_collision(Reaction::retreat)}), 60,
     false},
    {"StoppedInJointImpedance", behavior_with(Mode::joint_impedance, {}), 0, true},
    {"StoppedInCartesianImpedance", behavior_with(Mode::cartesian_impedance, {}), 0, true},
};

INSTANTIATE_TEST_SUITE_P(Stop, LeftWithoutABehavior, testing::ValuesIn(kWays),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Stop, OutOfTheUsualGravityCompensationLeavesTheUsualBehaviorOfPosition) {
  Rig rig(empty_scene());
  rig.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  rig.unit.stop();
  EXPECT_EQ(rig.unit.behavior(), usual_behavior(Mode::position));
}

TEST(Stop, LeavesABehaviorOfPositionAsItIs) {
  Crash crash;
  Behavior behavior = position_with({on_collision(Reaction::retreat)});
  behavior.operational.speed = 0.1;
  crash.rig.unit.set_behavior(behavior);
  crash.rig.unit.stop();
  EXPECT_EQ(crash.rig.unit.behavior(), behavior);
  crash.run();
  ASSERT_TRUE(crash.failure);
  EXPECT_EQ(crash.failure->reaction, "retreat");
}

class WhatLimits : public testing::TestWithParam<Mode> {};

TEST_P(WhatLimits, OutlastsAStop) {
  Rig rig(empty_scene());
  const double wall = rig.world->pose("tcp").position[1] + 0.2;
  Behavior behavior = usual_behavior(GetParam());
  behavior.operational.speed = 0.1;
  behavior.reflexes.push_back({.signal = Signal::virtual_wall, .wall = Plane{{0, wall, 0}, {0, -1, 0}}});
  rig.unit.set_behavior(behavior);
  rig.unit.stop();
  double fastest = 0;
  rig.each_step = [&, before = rig.world->pose("tcp").position]() mutable {
    const Vec3 now = rig.world->pose("tcp").position;
    fastest = std::max(fastest, distance(now, before) / ControlUnit::kPeriod);
    before = now;
  };
  const auto failure = rig.move({.target = Offset{{0, 0.3, 0}}, .kind = MotionKind::linear, .speed = 1});
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code, "virtual_wall");
  EXPECT_LT(fastest, 0.11);
  rig.run(1);
  EXPECT_LT(rig.world->pose("tcp").position[1], wall);
}

INSTANTIATE_TEST_SUITE_P(Stop, WhatLimits,
                         testing::Values(Mode::position, Mode::joint_impedance, Mode::cartesian_impedance,
                                         Mode::gravity_compensation),
                         [](const auto& info) { return std::string(name(info.param)); });

TEST(Stop, ByAWallThatAHandLedTheArmToIsToldOnce) {
  Rig rig(empty_scene());
  const double wall = rig.world->pose("tcp").position[1] + 0.05;
  rig.unit.set_behavior(behavior_with(Mode::gravity_compensation,
                                      {{.signal = Signal::virtual_wall, .wall = Plane{{0, wall, 0}, {0, -1, 0}}}}));
  rig.each_step = [&] { rig.world->push("gripper", {0, 15, 0}, rig.world->pose("tcp").position); };
  rig.run(2);
  int told = 0;
  for (const Incident& incident : rig.unit.take_incidents()) told += incident.signal == Signal::virtual_wall ? 1 : 0;
  EXPECT_EQ(told, 1);
  EXPECT_EQ(rig.unit.behavior().operational.mode, Mode::position);
}

}  // namespace
}  // namespace race::robot
