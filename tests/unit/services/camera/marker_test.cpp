// Printed markers as the camera draws them: the code's cells, the right way round, on the side they are printed on.
#include "services/camera/marker.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "services/camera/vector_internal.h"
#include "services/camera/view.h"
#include "services/marker.h"

namespace race::camera {
namespace {

constexpr double kSide = 0.06;
// Before the camera, z towards it, x to its right, y up in the picture.
const world::Pose kFacing{{0, 0, 0.5}, {1, 0, 0, 0}};

/// The picture of a grey card with a marker on it.
Picture picture_of(int id, const world::Pose& c_t_card) {
  std::vector<Item> items{{{world::Shape::Kind::box, {0.1, 0.1, 1e-4}}, c_t_card, {128, 128, 128}}};
  add_marker({id, kSide, {}}, c_t_card, items);
  return rasterize(items, kinect());
}

/// What is seen at (x, y) [m] of the plane z = 0.5 m, y up.
int red_at(const Picture& picture, double x, double y) {
  const Intrinsics k = kinect();
  const auto u = static_cast<std::size_t>(std::lround(k.cx + k.fx * x / 0.5));
  const auto v = static_cast<std::size_t>(std::lround(k.cy - k.fy * y / 0.5));
  return picture.colour[v * 640 + u].r;
}

TEST(Marker, ShowsTheCellsOfItsCodeInABlackRim) {
  for (const int id : {0, 7, 23, 49}) {
    const Picture picture = picture_of(id, kFacing);
    for (int row = -1; row <= services::kMarkerInner; ++row) {
      for (int column = -1; column <= services::kMarkerInner; ++column) {
        const bool rim = row < 0 || column < 0 || row == services::kMarkerInner || column == services::kMarkerInner;
        const bool white = !rim && services::is_white(id, row, column);
        const int seen = red_at(picture, (column - 1.5) * kSide / 6, (1.5 - row) * kSide / 6);
        EXPECT_EQ(seen > 128, white) << "id " << id << ", row " << row << ", column " << column << ": " << seen;
      }
    }
    const int card = red_at(picture, 0.04, 0);
    EXPECT_GT(card, 60) << "beside the marker";
    EXPECT_LT(card, 128);
  }
}

TEST(Marker, IsNotSeenFromBehindItsCard) {
  const Picture picture = picture_of(7, {{0, 0, 0.5}, {0, 0, 0, 1}});
  const Picture card = rasterize(
      {{{world::Shape::Kind::box, {0.1, 0.1, 1e-4}}, {{0, 0, 0.5}, {0, 0, 0, 1}}, {128, 128, 128}}}, kinect());
  EXPECT_EQ(picture.colour, card.colour);
}

TEST(Marker, MovesWithItsBodyAndLeavesWithIt) {
  world::Scene scene = world::load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json").value();
  const world::RobotModel robot = world::load_urdf(scene.robot.urdf).value();
  const auto items_of = [&](const world::World& world) { return view(world, scene.camera->o_t_c).size(); };
  const std::size_t without = items_of(*world::World::create(scene, robot).value());
  const auto cube = std::ranges::find(scene.bodies, "cube_red", &world::Body::name);
  cube->markers = {{7, 0.03, {{0, 0, 0.02}, {0, 0, 0, 1}}}};
  const auto world = world::World::create(scene, robot).value();
  const auto items = view(*world, scene.camera->o_t_c);
  EXPECT_GT(items.size(), without);
  const world::Pose c_t_cube = compose(inverse(scene.camera->o_t_c), world->pose("cube_red"));
  const auto black = std::ranges::find(items, Rgb{20, 20, 20}, &Item::colour);
  ASSERT_NE(black, items.end());
  EXPECT_LT(norm(black->c_t_shape.position - transform(c_t_cube, {0, 0, 0.02})), 1.1e-4);
  ASSERT_TRUE(world->take("cube_red"));
  EXPECT_EQ(items_of(*world), without - 1);
}

}  // namespace
}  // namespace race::camera
