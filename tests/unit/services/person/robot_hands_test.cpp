// A hand on the robot: the spring, the observer that feels it, and what each behavior makes of it.
#include "services/world/frames.h"
#include "services/world/person.h"
#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

using world::operator+;  // Vec3 is a std::array: found by name alone
using world::operator-;
using world::operator*;
using world::Hold;
using world::Person;

struct Led : Rig {
  Led() : Rig(empty_scene()), person(*world) {
    each_step = [this] { person.step(); };  // before the next step of the world
  }
  Vec3 tool() const { return world->pose("tcp").position; }
  world::Touch hand() const { return person.touches().at(0).second; }

  Person person;
};

const Hold kTool{.body = "gripper", .point = {0, 0, 0.15}, .stiffness = 500};  // the tool centre point

TEST(HandOnRobot, ExertsTheStiffnessTimesTheWay) {
  Led led;
  led.run(0.2);
  const Vec3 start = led.tool();
  ASSERT_TRUE(led.person.grab("right", kTool));
  ASSERT_TRUE(led.person.drag("right", {{start + Vec3{0, 0.05, 0}}, 0.5}));
  led.run(2);
  const Vec3 stretched = start + Vec3{0, 0.05, 0} - led.tool();
  EXPECT_LT(distance(led.hand().force, 500.0 * stretched), 0.01);
  EXPECT_NEAR(led.hand().force[1], 25, 2) << "position control hardly gives way";
}

TEST(HandOnRobot, IsFeltByTheObserverOfARobotThatHoldsItsPosition) {
  Led led;
  led.run(0.2);
  const Vec3 start = led.tool();
  ASSERT_TRUE(led.person.grab("right", kTool));
  ASSERT_TRUE(led.person.drag("right", {{start + Vec3{0.03, 0.05, -0.02}}, 0.5}));
  led.run(2);
  EXPECT_LT(distance(led.tool(), start), 0.01);
  const Vec3 force = led.hand().force;
  EXPECT_GT(distance(force, Vec3{}), 20);
  EXPECT_LT(distance(led.unit.state().external.force, force), 0.1 * distance(force, Vec3{}));
}

TEST(HandOnRobot, LeadsARobotInGravityCompensation) {
  Led led;
  led.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  led.run(0.2);
  const Vec3 goal = led.tool() + Vec3{0.05, 0.15, 0.05};
  ASSERT_TRUE(led.person.grab("right", kTool));
  ASSERT_TRUE(led.person.drag("right", {{goal}, 0.2}));
  led.run(4);
  EXPECT_LT(distance(led.tool(), goal), 0.01);
  led.person.release("right");
  led.run(1);
  EXPECT_LT(distance(led.tool(), goal), 0.03) << "and it stays there";
}

TEST(HandOnRobot, GivesWayAtItsLimit) {
  Led led;
  led.run(0.2);
  ASSERT_TRUE(led.person.grab("right", {.body = "link_4", .point = {}, .stiffness = 2000, .force = 40}));
  ASSERT_TRUE(led.person.drag("right", {{led.world->pose("link_4").position + Vec3{0, 0.3, 0}}}));
  led.run(1);
  EXPECT_NEAR(distance(led.hand().force, Vec3{}), 40, 1e-9);
}

TEST(PushOnRobot, OfAnAccidentIsFeltWhileItLasts) {
  Led led;
  led.run(0.2);
  ASSERT_TRUE(led.person.push({"gripper", {0, 80, 0}, {0, 0, 0.15}, 0.06, 0.005}));
  double felt = 0;
  for (int i = 0; i < 60; ++i) {
    led.step();
    felt = std::max(felt, led.unit.state().external.force[1]);
  }
  EXPECT_GT(felt, 60);
  led.run(0.3);
  EXPECT_LT(distance(led.unit.state().external.force, Vec3{}), 5);
}

TEST(PushOnRobot, ActsOnWhatAFrameSitsOn) {
  Led led;
  led.run(0.2);
  ASSERT_TRUE(led.person.push({"tcp", {0, 25, 0}, {}, 1, 0.1}));
  led.run(0.5);
  EXPECT_NEAR(led.unit.state().external.force[1], 25, 2.5);
}

}  // namespace
}  // namespace race::robot
