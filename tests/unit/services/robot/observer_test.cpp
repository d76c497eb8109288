// The external torques that the control unit feels, against forces that the test knows.
#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

class KnownForce : public testing::TestWithParam<Vec3> {};

TEST_P(KnownForce, IsReadWithinTenPercent) {
  Rig rig(empty_scene());
  rig.each_step = [&] { rig.world->push("gripper", GetParam(), rig.world->pose("tcp").position); };
  rig.run(1);
  const Vec3 read = rig.unit.state().external.force;
  const double size = distance(GetParam(), Vec3{});
  EXPECT_LT(distance(read, GetParam()), 0.1 * size);
}

INSTANTIATE_TEST_SUITE_P(Observer, KnownForce,
                         testing::Values(Vec3{20, 0, 0}, Vec3{0, -20, 0}, Vec3{0, 0, 30}, Vec3{10, 15, -20}));

TEST(Observer, ReadsNothingWhileTheArmMovesFreely) {
  Rig rig(empty_scene());
  double worst = 0;
  rig.each_step = [&] {
    for (std::size_t i = 0; i < kJoints; ++i)
      worst = std::max(worst, std::abs(rig.unit.state().tau_ext[i]) / lwr_settings().contact_thresholds[i]);
  };
  ASSERT_FALSE(rig.move({.target = Joints{1.2, -0.9, 0.3, 1.2, 0.4, -0.7, 1}, .speed = 1, .acceleration = 1}));
  ASSERT_FALSE(rig.move({.target = Joints{-1.2, -0.2, 0, 1.8, -0.4, -1, -1}, .speed = 1, .acceleration = 1}));
  EXPECT_LT(worst, 0.4) << "share of the contact threshold";
  EXPECT_FALSE(rig.unit.take_contact());
}

TEST(Contact, IsRaisedOnceWhenTheToolMeetsTheTable) {
  Rig rig(demo_scene());
  ASSERT_FALSE(rig.move({.target = down_at(0.6, -0.32, 0.06)}));
  EXPECT_FALSE(rig.unit.take_contact());
  ASSERT_TRUE(rig.unit.move({.target = Offset{{0, 0, -0.1}}, .kind = MotionKind::linear, .speed = 0.05}));
  int contacts = 0;
  double force_at_contact = 0;
  for (int i = 0; i < 20000 && contacts == 0; ++i) {
    rig.step();
    if (const auto contact = rig.unit.take_contact()) {
      ++contacts;
      force_at_contact = wrench_at_tool(rig.unit.arm(), rig.world->q(), contact->torques).force[2];
      EXPECT_EQ(rig.unit.arm().links()[contact->joint].substr(0, 5), "link_");
      rig.unit.stop();
    }
  }
  ASSERT_EQ(contacts, 1);
  EXPECT_GT(force_at_contact, 5) << "the table pushes upwards";
  EXPECT_LT(force_at_contact, 40);
  rig.run(1);
  EXPECT_FALSE(rig.unit.take_contact());
  const double real =
      rig.world->contact_force("finger_left", "table") + rig.world->contact_force("finger_right", "table");
  EXPECT_NEAR(rig.unit.state().external.force[2], real, 0.1 * real + 0.5);
}

TEST(Contact, IsRaisedAgainAfterItEnded) {
  Rig rig(empty_scene());
  Vec3 force{0, 25, 0};
  rig.each_step = [&] { rig.world->push("gripper", force, rig.world->pose("tcp").position); };
  rig.run(0.5);
  EXPECT_TRUE(rig.unit.take_contact());
  rig.run(0.5);
  EXPECT_FALSE(rig.unit.take_contact());
  force = {};
  rig.run(0.5);
  force = {0, -25, 0};
  rig.run(0.5);
  EXPECT_TRUE(rig.unit.take_contact());
}

TEST(Contact, NamesTheLinkOrOneFartherIn) {
  Rig rig(empty_scene());
  rig.each_step = [&] {
    Vec3 elbow = rig.world->pose("link_4").position;
    rig.world->push("link_4", {0, 60, 0}, elbow);
  };
  rig.run(0.5);
  const auto contact = rig.unit.take_contact();
  ASSERT_TRUE(contact);
  EXPECT_LE(contact->joint, 3U);
}

}  // namespace
}  // namespace race::robot
