// The rasteriser against rays: for each pixel the nearest intersection with the exact shapes, computed another way.
#include "services/camera/rasterizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "services/camera/vector_internal.h"

namespace race::camera {
namespace {

using world::Pose;
using world::Shape;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Where a ray from `from` along `along` enters a convex body given as intersection of slabs and rounds; kNowhere: it
/// does not.
struct Interval {
  double in = -kNowhere, out = kNowhere;
  void meet(double a, double b) {
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  void slab(double p, double d, double half) {
    if (d == 0) {
      if (std::abs(p) > half) out = -kNowhere;
    } else {
      meet((-half - p) / d, (half - p) / d);
    }
  }
  void round(double a, double half_b, double c) {  // a t2 + 2 half_b t + c <= 0
    const double discriminant = half_b * half_b - a * c;
    if (discriminant < 0 || a == 0) {
      if (a != 0 || c > 0) out = -kNowhere;
      return;
    }
    const double root = std::sqrt(discriminant);
    meet((-half_b - root) / a, (-half_b + root) / a);
  }
};

double hit(const Shape& shape, const Vec3& p, const Vec3& d) {
  Interval t;
  switch (shape.kind) {
    case Shape::Kind::box:
      for (std::size_t i = 0; i < 3; ++i) t.slab(p[i], d[i], shape.size[i] / 2);
      break;
    case Shape::Kind::cylinder:
      t.slab(p[2], d[2], shape.size[1] / 2);
      t.round(d[0] * d[0] + d[1] * d[1], p[0] * d[0] + p[1] * d[1],
              p[0] * p[0] + p[1] * p[1] - shape.size[0] * shape.size[0]);
      break;
    case Shape::Kind::sphere:
      t.round(dot(d, d), dot(p, d), dot(p, p) - shape.size[0] * shape.size[0]);
      break;
  }
  return t.in <= t.out && t.in > 0 ? t.in : kNowhere;
}

double ray_depth(const std::vector<Item>& items, const Vec3& ray) {
  double nearest = kNowhere;
  for (const Item& item : items) {
    const Pose shape_t_c = inverse(item.c_t_shape);
    nearest = std::min(nearest, hit(item.shape, shape_t_c.position, rotate(shape_t_c.orientation, ray)));
  }
  return nearest;
}

std::vector<Item> random_items(std::mt19937& random) {
  const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  std::vector<Item> items;
  for (int i = 0; i < 20; ++i) {
    Item item;
    item.shape.kind = static_cast<Shape::Kind>(i % 3);
    item.shape.size = {in(0.05, 0.25), in(0.05, 0.25), in(0.05, 0.25)};
    Quaternion q{in(-1, 1), in(-1, 1), in(-1, 1), in(-1, 1)};
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& c : q) c /= length;
    item.c_t_shape = {{in(-0.6, 0.6), in(-0.5, 0.5), in(0.9, 2.5)}, q};
    item.colour = {static_cast<std::uint8_t>(i), 100, 200};
    items.push_back(item);
  }
  return items;
}

TEST(Rasterizer, AgreesWithRays) {
  std::mt19937 random(11);
  const Intrinsics k = with_field_of_view(160, 120, 57, 43);
  int compared = 0, apart = 0;
  for (int round = 0; round < 5; ++round) {
    const auto items = random_items(random);
    const Picture picture = rasterize(items, k);
    std::size_t pixel = 0;
    for (int v = 0; v < k.height; ++v) {
      for (int u = 0; u < k.width; ++u, ++pixel) {
        const double expected = ray_depth(items, {(u - k.cx) / k.fx, (v - k.cy) / k.fy, 1});
        const double drawn = picture.depth[pixel] > 0 ? static_cast<double>(picture.depth[pixel]) : kNowhere;
        ++compared;
        // Round shapes are polyhedra: their outlines and surfaces lie a little inside.
        if (drawn != expected && !(std::abs(drawn - expected) < 0.003)) ++apart;
      }
    }
  }
  EXPECT_LT(apart, compared / 100) << "of " << compared;
}

TEST(Rasterizer, IsExactForABoxUpToItsEdges) {
  const Intrinsics k = kinect();
  const double s = std::sqrt(0.5);
  const std::vector<Item> items{{{Shape::Kind::box, {0.3, 0.2, 0.1}}, {{0.05, -0.02, 1.0}, {s, 0, 0, s}}, {1, 2, 3}}};
  const Picture picture = rasterize(items, k);
  int inside = 0;
  std::size_t pixel = 0;
  for (int v = 0; v < k.height; ++v) {
    for (int u = 0; u < k.width; ++u, ++pixel) {
      const double expected = ray_depth(items, {(u - k.cx) / k.fx, (v - k.cy) / k.fy, 1});
      EXPECT_EQ(picture.depth[pixel] > 0, expected < kNowhere) << u << "," << v;
      if (expected == kNowhere) continue;
      ++inside;
      EXPECT_NEAR(picture.depth[pixel], expected, 1e-6);
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(Rasterizer, ShowsTheNearerOfTwoWhateverTheirOrder) {
  const Item near{{Shape::Kind::sphere, {0.1, 0, 0}}, {{0, 0, 1}, {0, 0, 0, 1}}, {200, 0, 0}};
  const Item far{{Shape::Kind::box, {1, 1, 0.1}}, {{0, 0, 2}, {0, 0, 0, 1}}, {0, 0, 200}};
  const Intrinsics k = with_field_of_view(101, 101, 50, 50);
  for (const auto& items : {std::vector{near, far}, std::vector{far, near}}) {
    const Picture picture = rasterize(items, k);
    const std::size_t middle = 50 * 101 + 50, aside = 50 * 101 + 30;
    EXPECT_NEAR(picture.depth[middle], 0.9, 1e-3);
    EXPECT_GT(picture.colour[middle].r, 0);
    EXPECT_NEAR(picture.depth[aside], 1.95, 1e-5);
    EXPECT_GT(picture.colour[aside].b, 0);
  }
}

TEST(Rasterizer, DrawsWhatReachesBehindTheCamera) {
  // A floor 0.5 m below that begins 2 m behind.
  const std::vector<Item> floor{{{Shape::Kind::box, {4, 0.1, 6}}, {{0, 0.55, 1}, {0, 0, 0, 1}}, {9, 9, 9}}};
  const Intrinsics k = kinect();
  const Picture picture = rasterize(floor, k);
  const std::size_t lowest = static_cast<std::size_t>(k.height - 1) * 640 + 320;
  EXPECT_NEAR(picture.depth[lowest], 0.5 * k.fy / (k.height - 1 - k.cy), 1e-5);
}

TEST(Rasterizer, TellsHowSlantedASurfaceIs) {
  const double half = 30 * std::numbers::pi / 180;  // turned by 60 degrees about x
  const std::vector<Item> items{
      {{Shape::Kind::box, {0.2, 0.2, 0.001}}, {{0, 0, 1}, {std::sin(half), 0, 0, std::cos(half)}}, {9, 9, 9}}};
  const Picture picture = rasterize(items, with_field_of_view(101, 101, 50, 50));
  EXPECT_NEAR(picture.facing[50 * 101 + 50], 0.5, 1e-3);
}

}  // namespace
}  // namespace race::camera
