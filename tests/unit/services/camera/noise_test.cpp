// The noise has the published size, and measurements are missing where they should be.
#include "services/camera/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace race::camera {
namespace {

Picture wall(double depth, double facing = 1.0, int width = 200, int height = 200) {
  const auto pixels = static_cast<std::size_t>(width * height);
  return {width, height, std::vector<float>(pixels, static_cast<float>(depth)),
          std::vector<float>(pixels, static_cast<float>(facing)), std::vector<Rgb>(pixels, Rgb{100, 150, 200})};
}

double share_measured(const Measurement& m) {
  double measured = 0;
  for (const auto mm : m.depth_mm) measured += mm > 0;
  return measured / static_cast<double>(m.depth_mm.size());
}

TEST(Noise, OfDepthGrowsWithTheSquareOfTheDistance) {
  for (const double z : {0.9, 1.2, 2.0, 3.5}) {
    double sum = 0, squares = 0, n = 0;
    // Distances around z, so that the steps of the disparity do not matter.
    for (int i = 0; i < 20; ++i) {
      const double at = z + 0.002 * i;
      for (const auto mm : measure(wall(at), static_cast<std::uint64_t>(i)).depth_mm) {
        const double error = mm / 1000.0 - at;
        sum += error;
        squares += error * error;
        ++n;
      }
    }
    const double step = 2.85e-3 * z * z;
    const double deviation = step / 2;
    const double expected = std::sqrt(deviation * deviation + step * step / 12);
    EXPECT_NEAR(std::sqrt(squares / n), expected, 0.1 * expected) << z << " m";
    EXPECT_NEAR(sum / n, 0, 0.1 * expected) << z << " m";
  }
}

TEST(Noise, DepthComesInStepsOfDisparity) {
  std::set<std::uint16_t> values;
  for (const auto mm : measure(wall(2.0), 1).depth_mm) values.insert(mm);
  EXPECT_GE(values.size(), 3U);
  for (auto it = std::next(values.begin()); it != values.end(); ++it) EXPECT_NEAR(*it - *std::prev(it), 11.4, 1.5);
}

TEST(Noise, NothingIsMeasuredOutOfRange) {
  EXPECT_EQ(share_measured(measure(wall(0.7), 1)), 0.0);
  EXPECT_EQ(share_measured(measure(wall(4.3), 1)), 0.0);
  EXPECT_EQ(share_measured(measure(wall(0.0), 1)), 0.0);
  EXPECT_EQ(share_measured(measure(wall(1.0), 1)), 1.0);
}

TEST(Noise, SlantedSurfacesAreLost) {
  EXPECT_EQ(share_measured(measure(wall(1, std::cos(69 * M_PI / 180)), 1)), 1.0);
  EXPECT_NEAR(share_measured(measure(wall(1, std::cos(77.5 * M_PI / 180)), 1)), 0.5, 0.03);
  EXPECT_EQ(share_measured(measure(wall(1, std::cos(86 * M_PI / 180)), 1)), 0.0);
}

TEST(Noise, HalfOfThePixelsBesideAnEdgeAreLost) {
  Picture picture = wall(1.0);
  for (int v = 0; v < 200; ++v)
    for (int u = 100; u < 200; ++u) picture.depth[static_cast<std::size_t>(v * 200 + u)] = 1.2F;
  int lost_at_edge = 0, lost_elsewhere = 0;
  const Measurement m = measure(picture, 1);
  for (int v = 0; v < 200; ++v)
    for (int u = 0; u < 200; ++u)
      if (m.depth_mm[static_cast<std::size_t>(v * 200 + u)] == 0)
        ++(u == 99 || u == 100 ? lost_at_edge : lost_elsewhere);
  EXPECT_NEAR(lost_at_edge, 200, 40);
  EXPECT_EQ(lost_elsewhere, 0);
}

TEST(Noise, DependsOnTheSeedAlone) {
  const Picture picture = wall(1.5);
  EXPECT_EQ(measure(picture, 3).depth_mm, measure(picture, 3).depth_mm);
  EXPECT_EQ(measure(picture, 3).colour, measure(picture, 3).colour);
  EXPECT_NE(measure(picture, 3).depth_mm, measure(picture, 4).depth_mm);
}

}  // namespace
}  // namespace race::camera
