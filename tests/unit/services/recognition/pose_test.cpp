// The error of recognised poses against the world's truth, on pictures with noise, over places, turns and seeds.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "services/camera/vector_internal.h"
#include "services/recognition/symmetry.h"
#include "tests/unit/services/recognition/cell.h"

namespace race::recognition {

namespace {

using testing::IsEmpty;

/// Where a body or link is, seen from the camera.
Pose truth(const world::World& world, const std::string& name) {
  const world::Pose c_t_x = camera::compose(camera::inverse(world.scene().camera->o_t_c), world.pose(name));
  return {c_t_x.position, c_t_x.orientation};
}

const std::map<std::string, std::string>& bodies_of_labels() {
  static const std::map<std::string, std::string> names{{"Cube", "cube_red"},
                                                        {"Box", "cube_blue"},
                                                        {"Block", "block_green"},
                                                        {"Tape", "can_yellow"},
                                                        {"Bar", "bar_violet"}};
  return names;
}

struct PoseError {
  double distance = 0, angle = 0;  // m, degrees
};

PoseError error_of(const Detection& detection, const Pose& truth, const std::vector<Part>& parts) {
  const auto part = std::ranges::find(parts, detection.label, &Part::label);
  const Symmetry symmetry(part->symmetry);
  const auto& a = detection.c_t_x.position;
  const auto& b = truth.position;
  return {std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]),
          symmetry.angle(detection.c_t_x.orientation, truth.orientation) * 180 / M_PI};
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The parts of the scene at places drawn at random, one to a field of the table, standing or lying as in the scene.
world::Scene scattered(std::uint64_t seed) {
  world::Scene scene = demo_scene();
  scene.camera->o_t_c.position = {1.3, 0, 0.75};  // along its axis, to 1.06 m from the middle of the table
  std::mt19937_64 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  std::vector<int> fields{0, 1, 2, 3, 4, 5};
  std::ranges::shuffle(fields, random);
  std::size_t next = 0;
  for (const char* name : {"cube_red", "cube_blue", "block_green", "can_yellow", "bar_violet", "fake_yellow"}) {
    const int field = fields[next++];
    world::Pose& pose = body(scene, name).o_t_body;
    pose.position[0] = 0.62 + 0.12 * (field / 3) + in(-0.02, 0.02);
    pose.position[1] = -0.24 + 0.24 * (field % 3) + in(-0.05, 0.05);
    pose.orientation = yaw(in(-M_PI, M_PI));
  }
  return scene;
}

TEST(Pose, OfEveryPartIsWithinFiveMillimetresAndThreeDegrees) {
  const auto parts = demo_parts();
  const Recognizer recognizer(parts);
  std::map<std::string, std::vector<double>> distances, angles;
  constexpr int kScenes = 20;
  double seconds = 0;
  for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
    const auto world = build(scattered(seed));
    const RgbdImage image = measured(*world, seed);
    const auto begin = std::chrono::steady_clock::now();
    const auto detections = recognizer.recognize(image, recognizer.labels());
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    for (const Detection& detection : detections) {
      const auto name = bodies_of_labels().find(detection.label);
      if (name == bodies_of_labels().end()) continue;
      const PoseError error = error_of(detection, truth(*world, name->second), parts);
      distances[detection.label].push_back(error.distance);
      angles[detection.label].push_back(error.angle);
      EXPECT_LT(error.distance, 0.015) << detection.label << ", seed " << seed;
    }
  }
  for (const auto& [label, unused] : bodies_of_labels()) {
    ASSERT_GE(distances[label].size(), kScenes * 9 / 10) << label << " is found in nine of ten scenes";
    EXPECT_LE(median(distances[label]), 0.005) << label;
    EXPECT_LE(median(angles[label]), 3.0) << label;
    std::printf("%-6s found %zu/%d, median %.2f mm %.2f deg, worst %.2f mm %.2f deg\n", label.c_str(),
                distances[label].size(), kScenes, 1000 * median(distances[label]), median(angles[label]),
                1000 * *std::ranges::max_element(distances[label]), *std::ranges::max_element(angles[label]));
  }
  std::printf("%.0f ms for a picture\n", 1000 * seconds / kScenes);
}

TEST(FalsePart, IsRejectedThoughItHasTheColour) {
  const Recognizer recognizer(demo_parts());
  using world::Shape;
  const std::vector<std::pair<std::string, Shape>> fakes = {
      {"fake_yellow", {Shape::Kind::box, {0.05, 0.05, 0.05}}},    // as in the scene
      {"fake_yellow", {Shape::Kind::box, {0.04, 0.04, 0.08}}},    // the box around the Tape
      {"fake_yellow", {Shape::Kind::cylinder, {0.02, 0.05, 0}}},  // a shorter Tape
      {"fake_yellow", {Shape::Kind::cylinder, {0.03, 0.08, 0}}},  // a thicker one
      {"fake_yellow", {Shape::Kind::sphere, {0.03, 0, 0}}}};
  for (std::size_t i = 0; i < fakes.size(); ++i) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      world::Scene scene = scattered(seed);
      body(scene, "can_yellow").o_t_body.position = {2, 2, 0};  // out of sight
      world::Body& fake = body(scene, fakes[i].first);
      fake.shape = fakes[i].second;
      const bool box = fake.shape.kind == Shape::Kind::box, ball = fake.shape.kind == Shape::Kind::sphere;
      fake.o_t_body.position[2] = box ? fake.shape.size[2] / 2 : ball ? fake.shape.size[0] : fake.shape.size[1] / 2;
      const auto world = build(scene);
      EXPECT_THAT(labels_in(recognizer.recognize(measured(*world, seed), {"Tape"})), IsEmpty())
          << "false part " << i << ", seed " << seed;
    }
  }
}

TEST(Recognizer, FindsOnlyWhatIsAskedFor) {
  const Recognizer recognizer(demo_parts());
  const auto world = build(demo_scene());
  const RgbdImage image = measured(*world, 1);
  EXPECT_THAT(labels_in(recognizer.recognize(image, {"Bar"})), testing::ElementsAre("Bar"));
  EXPECT_THAT(labels_in(recognizer.recognize(image, {})), IsEmpty());
  EXPECT_THAT(labels_in(recognizer.recognize(image, recognizer.labels())),
              testing::UnorderedElementsAre("Cube", "Box", "Block", "Tape", "Bar", "Tool"));
}

TEST(Recognizer, FindsNothingInAnEmptyPicture) {
  const Recognizer recognizer(demo_parts());
  RgbdImage image = measured(*build(demo_scene()), 1);
  std::ranges::fill(image.depth_mm, 0);
  EXPECT_THAT(recognizer.recognize(image, recognizer.labels()), IsEmpty());
}

TEST(Recognizer, GivesTheSameForTheSamePicture) {
  const Recognizer recognizer(demo_parts());
  const RgbdImage image = measured(*build(demo_scene()), 3);
  const auto first = recognizer.recognize(image, recognizer.labels());
  const auto second = recognizer.recognize(image, recognizer.labels());
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].c_t_x.position, second[i].c_t_x.position);
    EXPECT_EQ(first[i].c_t_x.orientation, second[i].c_t_x.orientation);
  }
}

TEST(Recognizer, LaysTheAxesOfAPartAtRestUprightWhateverItsTurn) {
  const auto parts = demo_parts();
  const Recognizer recognizer(parts);
  for (int quarter = 0; quarter < 4; ++quarter) {
    world::Scene scene = demo_scene();
    body(scene, "cube_red").o_t_body.orientation = yaw(0.3 + quarter * M_PI / 2);
    const auto world = build(scene);
    const auto found = recognizer.recognize(measured(*world, 5), {"Cube"});
    ASSERT_EQ(found.size(), 1U);
    const auto o_t_x =
        camera::compose(world->scene().camera->o_t_c, {found[0].c_t_x.position, found[0].c_t_x.orientation});
    EXPECT_GT(camera::rotate(o_t_x.orientation, {0, 0, 1})[2], 0.998) << "z is up";
    const auto x = camera::rotate(o_t_x.orientation, {1, 0, 0});
    // The camera's right is the world's y: of the four turns the one nearest to it.
    EXPECT_NEAR(std::atan2(x[1], x[0]), M_PI / 2 + 0.3, 0.05);
  }
}

// The calibration body tells where the tool centre point is, in every posture in which its balls are seen.
TEST(Tool, IsFoundWhereTheRobotHasIt) {
  const auto parts = demo_parts();
  const Recognizer recognizer(parts);
  std::vector<double> distances, angles;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    world::Scene scene = demo_scene();
    std::mt19937_64 random(seed);
    for (double& q : scene.robot.q) q += std::uniform_real_distribution(-0.2, 0.2)(random);
    const auto world = build(scene);
    for (const Detection& detection : recognizer.recognize(measured(*world, seed), {"Tool"})) {
      const PoseError error = error_of(detection, truth(*world, "tcp"), parts);
      distances.push_back(error.distance);
      angles.push_back(error.angle);
    }
  }
  ASSERT_GE(distances.size(), 13U);
  std::printf("Tool found %zu/15, median %.2f mm %.2f deg, worst %.2f mm %.2f deg\n", distances.size(),
              1000 * median(distances), median(angles), 1000 * *std::ranges::max_element(distances),
              *std::ranges::max_element(angles));
  EXPECT_LE(median(distances), 0.005);
  EXPECT_LE(median(angles), 3.0);
}

TEST(Tool, IsInThePartsFileAsInTheUrdf) {
  const auto world = build(demo_scene());
  const world::RobotModel& model = world->model();
  const auto& visuals = model.links[static_cast<std::size_t>(model.link("calibration_body"))].visuals;
  const auto tcp_t_body = camera::compose(camera::inverse(world->pose("tcp")), world->pose("calibration_body"));
  std::vector<Part> parts = demo_parts();
  const auto tool = std::ranges::find(parts, "Tool", &Part::label);
  ASSERT_NE(tool, parts.end());
  for (const Piece& piece : tool->pieces) {
    const auto same = [&](const world::Visual& visual) {
      const auto at = camera::transform(tcp_t_body, visual.link_t_shape.position);
      const camera::Rgb colour = camera::parse_colour(visual.colour);
      return visual.shape.kind == world::Shape::Kind::sphere && visual.shape.size[0] == piece.size[0] &&
             camera::norm(camera::operator-(at, piece.x_t_piece.position)) < 1e-6 &&
             std::abs(colour.r - piece.colour[0]) + std::abs(colour.g - piece.colour[1]) +
                     std::abs(colour.b - piece.colour[2]) <=
                 6;
    };
    EXPECT_TRUE(std::ranges::any_of(visuals, same)) << "a ball at " << piece.x_t_piece.position[1];
  }
}

TEST(Parts, HaveTheShapesOfTheScene) {
  world::Scene scene = demo_scene();
  for (const Part& part : demo_parts()) {
    const auto name = bodies_of_labels().find(part.label);
    if (name == bodies_of_labels().end()) continue;
    const world::Body& there = body(scene, name->second);
    EXPECT_EQ(part.pieces[0].size, there.shape.size) << part.label;
    EXPECT_EQ(camera::parse_colour(there.colour),
              (camera::Rgb{part.pieces[0].colour[0], part.pieces[0].colour[1], part.pieces[0].colour[2]}));
  }
}

}  // namespace
}  // namespace race::recognition
