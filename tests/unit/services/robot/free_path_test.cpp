// Ways around what stands in the cell: the search itself, then on the real world.
#include "services/robot/free_path.h"

#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

/// A wall between the left and the right of the robot, as high as the tool's start.
world::Scene wall_scene() {
  world::Scene scene = demo_scene();
  std::erase_if(scene.bodies, [](const world::Body& body) { return body.mass > 0; });
  scene.bodies.push_back(fixed_box("wall", {0.5, 0.04, 0.35}, {0.6, 0, 0.175}));
  return scene;
}

const Joints kLeft = {0.7, -0.35, 0, 1.9, 0, -0.9, 0};
const Joints kRight = {-0.7, -0.35, 0, 1.9, 0, -0.9, 0};

struct Search : testing::Test {
  Rig rig{wall_scene()};
  Allowed allowed = [this](const Joints& q) { return rig.clearance.keeps(q, 0.02); };
  JointLimits limits = rig.unit.arm().limits();

  FreePath::State run(FreePath& path) {
    FreePath::State state = FreePath::State::searching;
    while (state == FreePath::State::searching) state = path.work(100);
    return state;
  }
};

TEST_F(Search, FindsAWayWhereTheStraightOneIsBlocked) {
  ASSERT_TRUE(allowed(kLeft));
  ASSERT_TRUE(allowed(kRight));
  int blocked = 0;
  for (int i = 0; i <= 100; ++i) {
    Joints q = kLeft;
    q[0] += (kRight[0] - kLeft[0]) * i / 100.0;
    blocked += allowed(q) ? 0 : 1;
  }
  ASSERT_GT(blocked, 10) << "the wall is in the way";
  for (unsigned seed = 1; seed <= 10; ++seed) {
    FreePath path(limits, allowed, kLeft, kRight, seed);
    ASSERT_EQ(run(path), FreePath::State::found) << "seed " << seed;
    EXPECT_EQ(path.places().front(), kLeft);
    EXPECT_EQ(path.places().back(), kRight);
    for (std::size_t k = 0; k < path.places().size(); ++k) {
      ASSERT_TRUE(allowed(path.places()[k])) << "seed " << seed << " place " << k;
      for (std::size_t i = 0; k > 0 && i < kJoints; ++i)
        ASSERT_LT(std::abs(path.places()[k][i] - path.places()[k - 1][i]), 2 * FreePath::kResolution);
    }
  }
}

TEST_F(Search, IsTheSameForTheSameSeed) {
  FreePath first(limits, allowed, kLeft, kRight, 5);
  FreePath second(limits, allowed, kLeft, kRight, 5);
  FreePath other(limits, allowed, kLeft, kRight, 6);
  run(first);
  // In other slices, too.
  while (second.work(7) == FreePath::State::searching) continue;
  run(other);
  EXPECT_EQ(first.places(), second.places());
  EXPECT_NE(first.places(), other.places());
}

TEST_F(Search, TakesTheStraightWayIfThatIsFree) {
  Joints near = kLeft;
  near[0] += 0.3;
  FreePath path(limits, allowed, kLeft, near, 1);
  ASSERT_EQ(run(path), FreePath::State::found);
  EXPECT_LT(path.checks(), 30);
  for (const Joints& q : path.places()) {
    for (std::size_t i = 1; i < kJoints; ++i) EXPECT_NEAR(q[i], kLeft[i], 1e-12);
  }
}

TEST_F(Search, GivesUpAfterItsChecksWhereThereIsNoWay) {
  // No posture with the first joint near zero is allowed: nothing leads from one side to the other.
  const Allowed never_across = [](const Joints& q) { return std::abs(q[0]) > 0.3; };
  FreePath path(limits, never_across, kLeft, kRight, 1);
  EXPECT_EQ(run(path), FreePath::State::failed);
  EXPECT_LT(path.checks(), FreePath::kMostChecks + 500);
}

TEST(FreeMotion, GoesAroundTheWallOnTheRealWorldAndTouchesNothing) {
  Rig rig(wall_scene());
  ASSERT_FALSE(rig.move({.target = kLeft, .kind = MotionKind::free}));
  double force = 0;
  rig.each_step = [&] {
    for (const char* body : {"wall", "table", "pedestal"}) {
      for (const char* link : {"link_3", "link_4", "link_5", "link_6", "gripper", "finger_left", "finger_right"})
        force += rig.world->contact_force(link, body);
    }
  };
  const auto failure = rig.move({.target = kRight, .kind = MotionKind::free, .speed = 1, .acceleration = 1});
  ASSERT_FALSE(failure) << failure->message;
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], kRight[i], 1e-3);
  EXPECT_EQ(force, 0);
  EXPECT_TRUE(rig.unit.take_incidents().empty());
}

TEST(FreeMotion, ReachesAPose) {
  Rig rig(wall_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.5, 0.3, 0.15), .kind = MotionKind::free}));
  const auto failure = rig.move({.target = down_at(0.5, -0.3, 0.15), .kind = MotionKind::free});
  ASSERT_FALSE(failure) << failure->message;
  EXPECT_LT(distance(rig.world->pose("tcp").position, {0.5, -0.3, 0.15}), 1e-3);
}

TEST(FreeMotion, IsRefusedWhereTheTargetIsInsideSomething) {
  Rig rig(wall_scene());
  const auto accepted = rig.unit.move({.target = down_at(0.6, 0, 0.2), .kind = MotionKind::free});
  ASSERT_FALSE(accepted);
  EXPECT_EQ(accepted.error().code, "path");
  EXPECT_EQ(accepted.error().argument, "target");
  EXPECT_EQ(rig.unit.move({.target = down_at(2, 0, 0.2), .kind = MotionKind::free}).error().code, "unreachable");
}

TEST(FreeMotion, CanBeStoppedWhileItIsSearched) {
  Rig rig(wall_scene());
  ASSERT_FALSE(rig.move({.target = kLeft, .kind = MotionKind::free}));
  ASSERT_TRUE(rig.unit.move({.target = kRight, .kind = MotionKind::free}));
  rig.run(0.002);
  ASSERT_TRUE(rig.unit.moving());
  rig.unit.stop();
  rig.run(1);
  EXPECT_FALSE(rig.unit.moving());
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], kLeft[i], 1e-3);
}

TEST(FreeMotion, IsAnsweredWhenNoWayIsFoundAndTheArmStaysWhereItWas) {
  Rig rig(empty_scene());
  ControlUnit unit(make_arm(*rig.world), lwr_settings(), kLeft,
                   [](const Joints& q, double) { return std::abs(q[0]) > 0.3; });
  ASSERT_TRUE(unit.move({.target = kRight, .kind = MotionKind::free}));
  std::optional<std::optional<Refusal>> outcome;
  for (int i = 0; i < 10000 && !outcome; ++i) {
    unit.control(kLeft, Joints{});
    outcome = unit.take_outcome();
  }
  ASSERT_TRUE(outcome && *outcome);
  EXPECT_EQ((*outcome)->code, "path");
  EXPECT_EQ((*outcome)->argument, "target");
  const Joints holding = unit.control(kLeft, Joints{});
  const Joints weight = unit.arm().gravity(kLeft);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(holding[i], weight[i], 1e-6);
}

TEST(Clearance, KeepsTheArmFromTheTableAndFromItself) {
  world::Scene scene = demo_scene();
  Rig rig(scene);
  EXPECT_TRUE(rig.clearance.keeps(scene.robot.q, 0.02));
  EXPECT_FALSE(rig.clearance.keeps({0, -1.8, 0, 1, 0, 0, 0}, 0)) << "bent down through the table";
  Rig alone(empty_scene());
  EXPECT_FALSE(alone.clearance.keeps({0, -1.7, 0, 2.09, 0, -2.09, 0}, 0)) << "folded, its fingers against its own foot";
}

TEST(Clearance, AgreesWithTheWorldOnTheDistanceToTheTable) {
  // The fingers' ends are 5 mm beyond the tool centre point.
  Rig rig(demo_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.6, -0.32, 0.035)}));
  const double gap = 0.035 - (0.085 + 0.08 - 0.15);
  EXPECT_TRUE(rig.clearance.keeps(rig.world->q(), gap - 1e-3));
  EXPECT_FALSE(rig.clearance.keeps(rig.world->q(), gap + 1e-3));
}

}  // namespace
}  // namespace race::robot
