// Every signal with every reaction, and every reaction in every mode: what the arm does, and how the motion ends.
// In gravity compensation no motion is there to slow down.
#include "tests/unit/services/robot/crash.h"

namespace race::robot {
namespace {

constexpr std::array kReactions = {Reaction::stop, Reaction::gravity_compensation, Reaction::retreat,
                                   Reaction::slow_down};

double fastest_joint(const Rig& rig) {
  double fastest = 0;
  for (const double speed : rig.world->dq()) fastest = std::max(fastest, std::abs(speed));
  return fastest;
}

class EachSignal : public testing::TestWithParam<std::tuple<Signal, Reaction>> {
 protected:
  /// A turn to the left that comes near a limit of joint 6; a hand pushes against it, or
  /// hits it, where the signal needs that.
  void run(const Reflex& reflex) {
    rig.each_step = [&] {
      if (reflex.signal == Signal::collision && rig.world->time() > 1.5) force = 60;
      const bool pushed = reflex.signal == Signal::contact || reflex.signal == Signal::force_limit;
      if (pushed && rig.world->time() > 0.5) force = std::min(25.0, force + 0.05);
      const double lasts = reflex.signal == Signal::collision ? 0 : 0.3;
      if (told_at && rig.world->time() > *told_at + lasts) force = 0;
      rig.world->push("gripper", {0, -force, 0}, tool());
      for (const Incident& incident : rig.unit.take_incidents()) {
        if (incident.signal != reflex.signal || told_at) continue;
        ASSERT_TRUE(incident.reflex);
        EXPECT_EQ(incident.reflex->reaction, reflex.reaction);
        told_at = rig.world->time();
        tool_then = tool();
      }
    };
    failure = rig.move({.target = Joints{0.9, -0.35, 0, 1.6, 0, -2.05, 0}, .speed = 0.3}, position_with({reflex}));
    ended_at = rig.world->time();
  }
  Vec3 tool() const { return rig.world->pose("tcp").position; }

  Rig rig{empty_scene()};
  double force = 0;
  std::optional<double> told_at;
  Vec3 tool_then{};
  std::optional<Refusal> failure;
  double ended_at = 0;
};

TEST_P(EachSignal, HasEachReaction) {
  const auto [signal, reaction] = GetParam();
  run({.signal = signal,
       .reaction = reaction,
       .force = 20,
       .wall = Plane{{0, 0.25, 0}, {0, -1, 0}},
       .margin = 0.2,
       .distance = 0.06});
  ASSERT_TRUE(told_at);
  if (reaction == Reaction::slow_down) {
    EXPECT_FALSE(failure) << failure->message;
    Rig undisturbed(empty_scene());
    undisturbed.move({.target = Joints{0.9, -0.35, 0, 1.6, 0, -2.05, 0}, .speed = 0.3});
    EXPECT_GT(ended_at, undisturbed.world->time() + 0.3) << "it arrives, later";
    return;
  }
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code, name(signal));
  EXPECT_EQ(failure->reaction, name(reaction));
  if (reaction == Reaction::retreat) {
    EXPECT_GT(ended_at, *told_at + 0.1) << "the answer comes when it is back";
    EXPECT_NEAR(distance(tool(), tool_then), 0.06, 0.02);
  } else {
    EXPECT_NEAR(ended_at, *told_at, 1.5 * ControlUnit::kPeriod);
  }
  const bool yields = reaction == Reaction::gravity_compensation;
  EXPECT_EQ(rig.unit.behavior().operational.mode, yields ? Mode::gravity_compensation : Mode::position);
  rig.run(1);
  if (reaction == Reaction::stop) {
    EXPECT_LT(distance(tool(), tool_then), 0.03);
  }
  if (!yields) {
    EXPECT_LT(fastest_joint(rig), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Reactions, EachSignal,
                         testing::Combine(testing::Values(Signal::contact, Signal::collision, Signal::force_limit,
                                                          Signal::virtual_wall, Signal::joint_limit),
                                          testing::ValuesIn(kReactions)),
                         [](const auto& info) {
                           return std::string(name(std::get<0>(info.param))) + "_" +
                                  std::string(name(std::get<1>(info.param)));
                         });

class EachMode : public testing::TestWithParam<std::tuple<Mode, Reaction>> {};

TEST_P(EachMode, ReactsWhenItMeetsAColumn) {
  const auto [mode, reaction] = GetParam();
  Crash crash;
  crash.run(behavior_with(mode, {{.signal = Signal::collision, .reaction = reaction}}));
  ASSERT_TRUE(crash.failure);
  ASSERT_FALSE(crash.incidents.empty());
  EXPECT_EQ(crash.incidents[0].reflex->reaction, reaction);
  const bool yields = reaction == Reaction::gravity_compensation;
  EXPECT_EQ(crash.rig.unit.behavior().operational.mode, yields ? Mode::gravity_compensation : mode);
  EXPECT_EQ(crash.failure->code, "collision");
  EXPECT_EQ(crash.failure->reaction, name(reaction));
  crash.rig.run(2);
  EXPECT_LT(fastest_joint(crash.rig), 0.02);
  if (reaction == Reaction::retreat) {
    EXPECT_NEAR(crash.met - crash.tool(), 0.05, 0.02);
    EXPECT_EQ(crash.force(), 0);
  } else {
    EXPECT_LT(crash.force(), yields ? 1 : 40) << "it no longer pushes";
  }
}

INSTANTIATE_TEST_SUITE_P(
    Reactions, EachMode,
    testing::Combine(testing::Values(Mode::position, Mode::joint_impedance, Mode::cartesian_impedance),
                     testing::Values(Reaction::stop, Reaction::gravity_compensation, Reaction::retreat)),
    [](const auto& info) {
      return std::string(name(std::get<0>(info.param))) + "_" + std::string(name(std::get<1>(info.param)));
    });

class SlowDownInEachMode : public testing::TestWithParam<Mode> {};

// A knock from the side: the path leads on, so what is measured is what the motion does, not what is in its way.
TEST_P(SlowDownInEachMode, TakesTheSpeedToItsShareAfterAKnockThenGivesItBack) {
  Rig rig(empty_scene());
  const Reflex reflex{.signal = Signal::collision, .reaction = Reaction::slow_down, .scale = 0.2};
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0.5, 0}}, .kind = MotionKind::linear, .speed = 0.3},
                            behavior_with(GetParam(), {reflex})));
  const auto speed = [&] {
    const double before = rig.world->pose("tcp").position[1];
    rig.run(0.1);
    return (rig.world->pose("tcp").position[1] - before) / 0.1;
  };
  rig.run(2);
  const double full = speed();
  for (int i = 0; i < 20; ++i) {
    rig.world->push("gripper", {0, 0, 40}, rig.world->pose("tcp").position);
    rig.step();
  }
  ASSERT_FALSE(rig.unit.take_incidents().empty());
  rig.run(0.3);
  const double slow = speed();
  rig.run(1);
  const double again = speed();
  EXPECT_GT(full, 0.1);
  EXPECT_NEAR(slow, 0.2 * full, 0.04 * full);
  EXPECT_GT(again, 0.8 * full);
  for (int i = 0; i < 20000 && rig.unit.moving(); ++i) rig.step();
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome);
  EXPECT_FALSE(*outcome) << "it arrives: " << (*outcome)->message;
}

INSTANTIATE_TEST_SUITE_P(Reactions, SlowDownInEachMode,
                         testing::Values(Mode::position, Mode::joint_impedance, Mode::cartesian_impedance),
                         [](const auto& info) { return std::string(name(info.param)); });

class LedByHand : public testing::TestWithParam<Reaction> {};

// There is no path to go back along and no speed to scale: a retreat is a stop, and slow_down is nothing.
TEST_P(LedByHand, StopsOrGoesOnGivingWay) {
  const Reaction reaction = GetParam();
  Rig rig(empty_scene());
  rig.unit.set_behavior(
      behavior_with(Mode::gravity_compensation, {{.signal = Signal::collision, .reaction = reaction}}));
  Vec3 force{};
  rig.each_step = [&] { rig.world->push("gripper", force, rig.world->pose("tcp").position); };
  rig.run(0.3);
  force = {0, 60, 0};
  rig.run(0.1);
  ASSERT_FALSE(rig.unit.take_incidents().empty());
  const bool holds = reaction == Reaction::stop || reaction == Reaction::retreat;
  EXPECT_EQ(rig.unit.behavior().operational.mode, holds ? Mode::position : Mode::gravity_compensation);
  const double there = rig.world->pose("tcp").position[1];
  rig.run(0.2);
  const double moved = rig.world->pose("tcp").position[1] - there;
  EXPECT_EQ(moved < 0.03, holds) << moved;
}

INSTANTIATE_TEST_SUITE_P(Reactions, LedByHand, testing::ValuesIn(kReactions),
                         [](const auto& info) { return std::string(name(info.param)); });

TEST(Retreat, KeepsTheSpeedOverride) {
  Crash crash;
  crash.rig.unit.set_override(0.25);
  crash.speed = 1;
  double fastest_back = 0;
  double before = crash.tool();
  crash.rig.each_step = [&] {
    const double now = crash.tool();
    // Not the rebound, which lasts some milliseconds.
    if (now < crash.met - 0.02) fastest_back = std::max(fastest_back, (before - now) / ControlUnit::kPeriod);
    before = now;
  };
  crash.run(position_with({{.signal = Signal::collision, .reaction = Reaction::retreat, .distance = 0.1}}));
  ASSERT_TRUE(crash.failure);
  EXPECT_EQ(crash.failure->reaction, "retreat");
  EXPECT_GT(fastest_back, 0.02);
  EXPECT_LT(fastest_back, 0.25 * 0.5 + 0.01) << "a quarter of the 0.5 m/s that were planned";
}

TEST(Retreat, OfAPausedMotionIsAStop) {
  Rig rig(empty_scene());
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0.25, 0}}, .kind = MotionKind::linear, .speed = 0.3},
                            position_with({{.signal = Signal::collision, .reaction = Reaction::retreat}})));
  rig.run(0.7);
  rig.unit.set_override(0);
  rig.run(0.3);
  const Vec3 paused = rig.world->pose("tcp").position;
  Vec3 force{0, 60, 0};
  rig.each_step = [&] { rig.world->push("gripper", force, rig.world->pose("tcp").position); };
  rig.run(0.2);
  const auto outcome = rig.unit.take_outcome();
  ASSERT_TRUE(outcome && *outcome);
  EXPECT_EQ((*outcome)->code, "collision");
  force = {};
  rig.run(0.5);
  EXPECT_LT(distance(rig.world->pose("tcp").position, paused), 0.01);
}

}  // namespace
}  // namespace race::robot
