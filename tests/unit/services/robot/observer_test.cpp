// The external torques that the control unit estimates, against forces that the test applies.
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
  EXPECT_TRUE(rig.unit.take_incidents().empty());
}

}  // namespace
}  // namespace race::robot
