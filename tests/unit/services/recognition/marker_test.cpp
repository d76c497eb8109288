// Printed markers: what is read of them in pictures with noise, and how they tell parts of one form and colour apart.
#include "services/camera/marker.h"

#include <gmock/gmock.h>

#include <map>
#include <optional>

#include "services/camera/vector_internal.h"
#include "services/marker.h"
#include "services/recognition/markers.h"
#include "services/recognition/symmetry.h"
#include "tests/unit/services/recognition/cell.h"

namespace race::recognition {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A camera that looks down at 45 degrees on the middle of the table, `distance` [m] away from it.
world::Pose camera_pose(double distance) {
  world::Pose o_t_c = demo_scene().camera->o_t_c;
  o_t_c.position = {0.65 + distance * std::sqrt(0.5), 0, distance * std::sqrt(0.5)};
  return o_t_c;
}

/// Where the corners of a marker are in the picture, from the world's truth.
std::array<ImagePoint, 4> corners(const world::Marker& marker, const world::Pose& c_t_body, const RgbdImage& image) {
  const double h = marker.side / 2;
  const world::Vec3 in_marker[] = {{-h, h, 0}, {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
  const world::Pose c_t_marker = camera::compose(c_t_body, marker.body_t_marker);
  std::array<ImagePoint, 4> out;
  for (std::size_t i = 0; i < 4; ++i) {
    const world::Vec3 p = camera::transform(c_t_marker, in_marker[i]);
    out[i] = {image.cx + image.fx * p[0] / p[2], image.cy + image.fy * p[1] / p[2]};
  }
  return out;
}

double farthest(const std::array<ImagePoint, 4>& a, const std::array<ImagePoint, 4>& b) {
  double most = 0;
  for (std::size_t i = 0; i < 4; ++i) most = std::max(most, std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1]));
  return most;
}

/// Around a marker with these corners, twice as wide.
Region around(const std::array<ImagePoint, 4>& corners) {
  const double u = (corners[0][0] + corners[2][0]) / 2, v = (corners[0][1] + corners[2][1]) / 2;
  const double room = std::hypot(corners[0][0] - corners[2][0], corners[0][1] - corners[2][1]);
  return {static_cast<int>(u - room), static_cast<int>(v - room), static_cast<int>(u + room),
          static_cast<int>(v + room)};
}

TEST(Markers, OfEveryIdAreReadAsTheyAreDrawnAndWhereTheyAre) {
  for (int id = 0; id < services::kMarkerIds; ++id) {
    // On a card 0.8 m away that faces the camera: z of the marker towards it, y up in the picture.
    const world::Pose c_t_card{{0.02, 0.01, 0.8}, {1, 0, 0, 0}};
    const world::Marker marker{id, 0.05, {}};
    std::vector<camera::Item> items{
        {{world::Shape::Kind::box, {0.1, 0.1, 1e-4}}, c_t_card, camera::parse_colour("#2f6fd0")}};
    camera::add_marker(marker, c_t_card, items);
    const RgbdImage image = measured(items, static_cast<std::uint64_t>(id));
    const auto truth = corners(marker, c_t_card, image);
    const auto seen = find_markers(image, around(truth));
    ASSERT_EQ(seen.size(), 1U) << "id and seed " << id;
    EXPECT_EQ(seen[0].id, id);
    EXPECT_LT(farthest(seen[0].corners, truth), 1.0) << "pixels; id and seed " << id;
  }
}

/// The three boxes of a scene with markers of 30, 40 and 60 mm on top, 5 mm from the edges, somewhere on the table.
world::Scene marked(std::uint64_t seed) {
  world::Scene scene = demo_scene();
  std::mt19937_64 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  int place = -1;
  for (const auto& [name, side] : {std::pair{"cube_red", 0.03}, {"cube_blue", 0.04}, {"block_green", 0.06}}) {
    world::Body& box = body(scene, name);
    const double edge = side + 0.01;
    box.shape = {world::Shape::Kind::box, {edge, edge, edge}};
    box.o_t_body = {{0.65 + in(-0.05, 0.05), 0.2 * place++ + in(-0.04, 0.04), edge / 2}, yaw(in(-M_PI, M_PI))};
    const int id = std::uniform_int_distribution(0, services::kMarkerIds - 1)(random);
    box.markers = {{id, side, {{0, 0, edge / 2}, {0, 0, 0, 1}}}};
  }
  for (const char* name : {"can_yellow", "bar_violet", "fake_yellow"}) body(scene, name).o_t_body.position[0] = 0.4;
  body(scene, "bar_violet").o_t_body.position[1] = -0.1;
  return scene;
}

world::Marker marker_of(const world::World& world, const std::string& name) {
  return std::ranges::find(world.scene().bodies, name, &world::Body::name)->markers.at(0);
}

struct Rate {
  int found = 0, wrong = 0;
  double worst = 0;  // pixels, of the corners
};

TEST(Markers, OfFortyMillimetresAreReadAtAMetreAndNoneIsMistaken) {
  constexpr int kScenes = 50;
  std::map<std::pair<double, double>, Rate> rates;  // of distance and side
  for (int seed = 1; seed <= kScenes; ++seed) {
    const auto world = build(marked(static_cast<std::uint64_t>(seed)));
    for (const double distance : {1.0, 1.5, 2.0}) {
      const world::Pose o_t_c = camera_pose(distance);
      const RgbdImage image = measured(camera::view(*world, o_t_c), static_cast<std::uint64_t>(seed));
      for (const char* name : {"cube_red", "cube_blue", "block_green"}) {
        const world::Marker marker = marker_of(*world, name);
        const auto truth = corners(marker, camera::compose(camera::inverse(o_t_c), world->pose(name)), image);
        Rate& rate = rates[{distance, marker.side}];
        for (const SeenMarker& each : find_markers(image, around(truth))) {
          ++(each.id == marker.id ? rate.found : rate.wrong);
          rate.worst = std::max(rate.worst, farthest(each.corners, truth));
        }
      }
    }
  }
  for (const auto& [key, rate] : rates)
    std::printf("%.1f m, %.0f mm: read in %d of %d scenes (seeds 1..%d), wrong ids %d, corners within %.1f pixels\n",
                key.first, 1000 * key.second, rate.found, kScenes, kScenes, rate.wrong, rate.worst);
  for (const auto& [key, rate] : rates) EXPECT_EQ(rate.wrong, 0) << key.first << " m, " << key.second << " m";
  for (const double side : {0.03, 0.04, 0.06}) EXPECT_GE((rates[{1.0, side}].found), kScenes * 9 / 10) << side << " m";
}

TEST(Markers, AreNotSeenWhereThereAreNone) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto world = build(demo_scene());
    EXPECT_THAT(find_markers(measured(*world, seed), {200, 150, 440, 400}), IsEmpty()) << "seed " << seed;
  }
  const RgbdImage image = measured(std::vector<camera::Item>{}, 1);
  EXPECT_THAT(find_markers(image, {-50, -50, 0, 100}), IsEmpty()) << "outside of the picture";
}

TEST(Markers, MayBeLookedForInAnyPictureHoweverSmall) {
  RgbdImage image = measured(std::vector<camera::Item>{}, 1);
  std::mt19937_64 random(1);  // the seed
  for (int size = 1; size <= 40; ++size) {
    for (auto& pixel : image.colour) pixel.fill(random() % 2 ? 240 : 20);
    for (const SeenMarker& each : find_markers(image, {300, 200, 300 + size, 200 + size}))
      for (const ImagePoint& corner : each.corners)
        EXPECT_TRUE(corner[0] > 299 && corner[0] < 301 + size) << "size " << size;
  }
}

/// A blue box of 5 cm that is told from others like it by a marker of 40 mm on its top; without an id, by none.
Part blue_box(const std::string& label, std::optional<int> id) {
  std::vector<Part> parts = demo_parts();
  Part part = *std::ranges::find(parts, "Box", &Part::label);
  part.label = label;
  if (id) part.markers = {{*id, 0.04, {{0, 0, 0.025}, {0, 0, 0, 1}}}};
  return part;
}

/// The table with two blue boxes somewhere on it: the scene's, and one in the place of the green block.
world::Scene two_boxes(std::uint64_t seed, std::vector<world::Marker> on_first, std::vector<world::Marker> on_second) {
  world::Scene scene = demo_scene();
  scene.camera->o_t_c = camera_pose(1.0);
  std::mt19937_64 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  world::Body &first = body(scene, "cube_blue"), &second = body(scene, "block_green");
  first.o_t_body = {{0.65 + in(-0.05, 0.05), -0.1 + in(-0.05, 0.05), 0.025}, yaw(in(-M_PI, M_PI))};
  first.markers = std::move(on_first);
  second.shape = first.shape;
  second.colour = first.colour;
  second.o_t_body = {{0.65 + in(-0.05, 0.05), 0.1 + in(-0.05, 0.05), 0.025}, yaw(in(-M_PI, M_PI))};
  second.markers = std::move(on_second);
  return scene;
}

world::Marker on_top(int id) { return {id, 0.04, {{0, 0, 0.025}, {0, 0, 0, 1}}}; }

TEST(MarkedPart, IsToldFromAnotherOfItsFormAndColourInPlaceAndTurn) {
  const Recognizer recognizer({blue_box("Left", 7), blue_box("Right", 23)});
  constexpr int kScenes = 15;
  int found = 0;
  double farthest = 0, most_turned = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const auto world = build(two_boxes(seed, {on_top(7)}, {on_top(23)}));
    for (const Detection& detection : recognizer.recognize(measured(*world, seed), recognizer.labels())) {
      const world::Pose truth = camera::compose(camera::inverse(world->scene().camera->o_t_c),
                                                world->pose(detection.label == "Left" ? "cube_blue" : "block_green"));
      const double off = camera::norm(camera::operator-(truth.position, detection.c_t_x.position));
      // A cube looks the same after 24 turns; the marker leaves one.
      const double turned = Symmetry({}).angle(truth.orientation, detection.c_t_x.orientation) * 180 / M_PI;
      EXPECT_LT(off, 0.005) << detection.label << ", seed " << seed;
      EXPECT_LT(turned, 3) << detection.label << ", seed " << seed;
      farthest = std::max(farthest, off);
      most_turned = std::max(most_turned, turned);
      ++found;
    }
  }
  std::printf("boxes found %d of %d (seeds 1..%d), worst %.2f mm %.2f deg\n", found, 2 * kScenes, kScenes,
              1000 * farthest, most_turned);
  EXPECT_GE(found, 2 * kScenes * 9 / 10);
}

TEST(MarkedPart, IsNotWhatHasAnotherMarkerOrNone) {
  const Recognizer recognizer({blue_box("Left", 7)});
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto found = [&](std::vector<world::Marker> on_first) {
      return labels_in(
          recognizer.recognize(measured(*build(two_boxes(seed, std::move(on_first), {on_top(23)})), seed), {"Left"}));
    };
    EXPECT_THAT(found({on_top(7)}), ElementsAre("Left")) << "seed " << seed;
    EXPECT_THAT(found({on_top(8)}), IsEmpty()) << "seed " << seed;
    EXPECT_THAT(found({}), IsEmpty()) << "seed " << seed;
    world::Marker below = on_top(7);
    below.body_t_marker = {{0, 0, -0.025}, {1, 0, 0, 0}};
    EXPECT_THAT(found({below}), IsEmpty()) << "its marker is not seen; seed " << seed;
    world::Marker small = on_top(7);
    small.side = 0.025;
    EXPECT_THAT(found({small}), IsEmpty()) << "a marker of another size; seed " << seed;
  }
}

TEST(MarkedPart, WithoutMarkersInTheFileIsWhatHasItsFormAndColourAsBefore) {
  const Recognizer recognizer({blue_box("Marked", 7), blue_box("Plain", {})});
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto world = build(two_boxes(seed, {on_top(7)}, {}));
    EXPECT_THAT(labels_in(recognizer.recognize(measured(*world, seed), recognizer.labels())),
                UnorderedElementsAre("Marked", "Plain"))
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace race::recognition
