// Which orientations are the same.
#include "services/recognition/symmetry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace race::recognition {
namespace {

Quaternion about(Vec3 axis, double degrees) {
  const double half = degrees * M_PI / 360;
  return {axis[0] * std::sin(half), axis[1] * std::sin(half), axis[2] * std::sin(half), std::cos(half)};
}

double degrees(const Symmetry& symmetry, const Quaternion& a, const Quaternion& b) {
  return symmetry.angle(a, b) * 180 / M_PI;
}

const Quaternion kNone{0, 0, 0, 1};
const Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

TEST(Symmetry, OfNothingIsTheAngleBetween) {
  const Symmetry none({});
  EXPECT_NEAR(degrees(none, kNone, about(kX, 170)), 170, 1e-6);
}

TEST(Symmetry, OfACubeKnowsAllOfItsTwentyFourTurns) {
  const Symmetry cube({{kZ, 4}, {kX, 4}});
  for (const Vec3& axis : {kX, kY, kZ})
    for (const double angle : {90.0, 180.0, 270.0}) EXPECT_NEAR(degrees(cube, kNone, about(axis, angle)), 0, 1e-6);
  const double s = 1 / std::sqrt(3.0);
  EXPECT_NEAR(degrees(cube, kNone, about({s, s, s}, 120)), 0, 1e-6);
  EXPECT_NEAR(degrees(cube, kNone, about(kZ, 50)), 40, 1e-6);
}

TEST(Symmetry, OfABlockKnowsHalfTurnsOnly) {
  const Symmetry block({{kZ, 2}, {kX, 2}});
  EXPECT_NEAR(degrees(block, kNone, about(kY, 180)), 0, 1e-6);
  EXPECT_NEAR(degrees(block, kNone, about(kZ, 90)), 90, 1e-6);
}

TEST(Symmetry, OfACylinderIsBlindForItsTurnAndItsEnds) {
  const Symmetry cylinder({{kZ, 0}, {kX, 2}});
  EXPECT_NEAR(degrees(cylinder, kNone, about(kZ, 77)), 0, 1e-6);
  EXPECT_NEAR(degrees(cylinder, kNone, about(kY, 180)), 0, 1e-6);
  EXPECT_NEAR(degrees(cylinder, kNone, about(kY, 25)), 25, 1e-6);
  const Symmetry cone({{kZ, 0}});
  EXPECT_NEAR(degrees(cone, kNone, about(kY, 180)), 180, 1e-6);
}

TEST(Symmetry, OfASphereIsBlindForEverything) {
  const Symmetry sphere({{kZ, 0}, {kX, 0}});
  EXPECT_EQ(degrees(sphere, about(kX, 33), about(kY, 77)), 0);
}

TEST(Symmetry, UprightIsTheSamePoseAsBefore) {
  const Symmetry cube({{kZ, 4}, {kX, 4}});
  const Quaternion tilted = about(kX, 190);
  const Quaternion upright = cube.upright(tilted, kZ, kX);
  EXPECT_NEAR(degrees(cube, tilted, upright), 0, 1e-5);
  EXPECT_NEAR(degrees(Symmetry({}), upright, about(kX, 10)), 0, 1e-5);
}

TEST(Symmetry, UprightTurnsACylinderToTheRight) {
  const Symmetry cylinder({{kZ, 0}, {kX, 2}});
  EXPECT_NEAR(degrees(Symmetry({}), cylinder.upright(about(kZ, 130), kZ, kX), kNone), 0, 1e-5);
}

}  // namespace
}  // namespace race::recognition
