// Poses: identities that hold for all of them, values worked out by hand, and faults.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/core/language/environment.h"

namespace race::language::test {
namespace {

constexpr const char* kPoses =
    "a = geo.pose([1, 2, 3], geo.rpy(0.3, -0.4, 2.5))\nb = geo.pose([-0.5, 0, 2], geo.rpy(-1.2, 0.9, 0.1))\n"
    "i = geo.identity()\n";

// What a function says of two poses a and b and the identity i.
std::string with_poses(const std::string& rest) {
  Runner r;
  return r.out(kPoses + rest);
}

TEST(Geo, InverseAndComposeAreAGroup) {
  EXPECT_EQ(with_poses("r = geo.compose(a, geo.inverse(a))\n"
                       "res.out = geo.distance(r, i) < 1e-12 and geo.angle(r, i) < 1e-7"),
            "true");
  EXPECT_EQ(with_poses("p = geo.compose(geo.compose(a, b), a)\nq = geo.compose(a, geo.compose(b, a))\n"
                       "res.out = geo.distance(p, q) < 1e-12 and geo.angle(p, q) < 1e-7"),
            "true");
  EXPECT_EQ(
      with_poses(
          "p = [0.1, 0.2, 0.3]\n"
          "res.out = geo.distance(geo.transform(geo.compose(a, b), p), geo.transform(a, geo.transform(b, p))) < 1e-12"),
      "true");
}

TEST(Geo, RotatesAboutFixedAxes) {
  EXPECT_EQ(with_poses("q = geo.pose([1, 0, 0], geo.rpy(0, 0, math.pi / 2))\np = geo.transform(q, [1, 0, 0])\n"
                       "res.out = [round(x, 12) + 0.0 for x in p]"),
            "[1.0,1.0,0.0]");
  EXPECT_EQ(
      with_poses("q = geo.pose([0, 0, 0], geo.rpy(math.pi / 2, 0, math.pi / 2))\np = geo.transform(q, [0, 1, 0])\n"
                 "res.out = [round(x, 12) + 0.0 for x in p]"),
      "[0.0,0.0,1.0]")
      << "x first, then z: y goes to z and stays";
  EXPECT_EQ(with_poses("res.out = [round(x, 12) + 0.0 for x in geo.to_rpy(a)]"), "[0.3,-0.4,2.5]");
  EXPECT_EQ(with_poses("q = geo.pose([0, 0, 0], geo.rpy(0.0, math.pi / 2, 0.7))\n"
                       "res.out = [round(x, 6) for x in geo.to_rpy(q)]"),
            "[0.0,1.570796,0.7]");
}

TEST(Geo, InterpolatesOnTheShorterArc) {
  EXPECT_EQ(with_poses("res.out = geo.distance(geo.interpolate(a, b, 0), a) < 1e-12 and geo.angle(geo.interpolate(a, "
                       "b, 1), b) < 1e-7"),
            "true");
  EXPECT_EQ(with_poses("h = geo.interpolate(a, b, 0.5)\nres.out = abs(geo.angle(a, h) - geo.angle(h, b)) < 1e-9"),
            "true");
  EXPECT_EQ(with_poses("n = geo.pose(i.position, [0, 0, 0, -1])\nres.out = geo.angle(geo.interpolate(i, n, 0.5), i)"),
            "0.0");
}

TEST(Geo, MeansAreBetween) {
  EXPECT_EQ(with_poses("m = geo.mean([a, a])\nres.out = geo.distance(m, a) < 1e-12 and geo.angle(m, a) < 1e-7"),
            "true");
  EXPECT_EQ(with_poses("l = geo.pose([0, 0, 0], geo.rpy(0, 0, 0.2))\nr = geo.pose([2, 0, 0], geo.rpy(0, 0, -0.2))\nm = "
                       "geo.mean([l, r])\n"
                       "res.out = [m.position, geo.angle(m, i) < 1e-7]"),
            "[[1.0,0.0,0.0],true]");
  EXPECT_EQ(with_poses("n = geo.pose([0, 0, 0], [0, 0, 0, -1])\nres.out = geo.mean([i, n]).orientation[3]"), "1.0")
      << "q and -q are one";
  EXPECT_EQ(with_poses("n = geo.pose([4, 0, 0], [0, 0, -0.6, -0.8])\nm = geo.mean([i, n, n])\n"
                       "res.out = [m.orientation[3] > 0, geo.angle(m, n) < geo.angle(m, i)]"),
            "[true,true]");
}

TEST(Geo, OffsetMovesAlongOwnAxes) {
  EXPECT_EQ(with_poses("q = geo.pose([1, 1, 1], geo.rpy(math.pi, 0, 0))\nres.out = [round(x, 12) + 0.0 for x in "
                       "geo.offset(q, 0, 0, 0.1).position]"),
            "[1.0,1.0,0.9]");
}

TEST(Geo, NormalisesQuaternionsAndRefusesBadOnes) {
  EXPECT_EQ(with_poses("res.out = geo.pose([0, 0, 0], [0, 0, 0, 2]).orientation"), "[0.0,0.0,0.0,1.0]");
  for (const char* text :
       {"geo.pose([0, 0, 0], [0, 0, 0, 0])", "geo.pose([0, 0, 0], [0, 0, math.inf, 1])",
        "geo.pose([0, 0, 0], [0, 0, math.nan, 1])", "geo.mean([])", "geo.interpolate(i, i, math.inf)"})
    EXPECT_EQ(with_poses("x = " + std::string(text)), "fault value") << text;
  for (const char* text : {"geo.pose([0, 0], [0, 0, 0, 1])", "geo.inverse(1)", "geo.inverse({'position': [0, 0, 0]})",
                           "geo.rpy(1, 2, 'a')", "geo.pose(['a', 0, 0], [0, 0, 0, 1])", "geo.compose(i)",
                           "geo.offset(i, 0, 0)", "geo.mean(5)"})
    EXPECT_EQ(with_poses("x = " + std::string(text)), "fault type") << text;
}

}  // namespace
}  // namespace race::language::test
