// What a hand exerts, against springs and weights that pencil and paper can check.
#include "services/world/frames.h"
#include "tests/unit/services/person/cell.h"

namespace race::world {
namespace {

constexpr double kWeight = 0.2 * 9.81;  // N, of the cube

ErrorCode code(const Expected<void>& result) { return result ? ErrorCode::io : result.error().code; }
std::string path(const Expected<void>& result) { return result ? "done" : result.error().path; }

TEST(Hand, CarriesAPartAndSagsByItsWeightOverTheStiffness) {
  Cell cell;
  ASSERT_TRUE(cell.person.grab("right", {.body = "cube", .stiffness = 400}));
  ASSERT_TRUE(cell.person.drag("right", {{{0.5, 0.3, 0.2}}, 0.5}));
  cell.run(2);
  EXPECT_NEAR(cell.cube()[2], 0.2 - kWeight / 400, 1e-5);
  EXPECT_NEAR(cell.hand().force[2], kWeight, 1e-3);
}

TEST(Hand, FollowsItsPathInTurnAtTheSpeedAsked) {
  Cell cell;
  ASSERT_TRUE(cell.person.grab("right", {.body = "cube"}));
  ASSERT_TRUE(cell.person.drag("right", {{{0.5, 0.3, 0.22}, {0.6, 0.3, 0.22}}, 0.1}));
  cell.run(1);
  EXPECT_NEAR((*cell.hand().target)[2], 0.12, 1e-9);
  cell.run(1.5);
  EXPECT_NEAR((*cell.hand().target)[0], 0.55, 1e-9);
  EXPECT_NEAR((*cell.hand().target)[2], 0.22, 1e-9);
  EXPECT_NEAR(cell.cube()[0], 0.55, 0.01) << "the part lags a little";
}

TEST(Hand, DrawsNoStrongerThanItsLimit) {
  Cell cell;
  ASSERT_TRUE(cell.person.grab("right", {.body = "cube", .stiffness = 5000, .force = 1.5}));
  ASSERT_TRUE(cell.person.drag("right", {{{0.5, 0.3, 0.5}}}));
  cell.run(1);
  EXPECT_NEAR(size(cell.hand().force), 1.5, 1e-9);
  EXPECT_NEAR(cell.cube()[2], 0.02, 1e-3) << "the cube weighs more than that";
}

TEST(Hand, HoldsAPartByACornerWithoutTurningIt) {
  Cell cell;
  ASSERT_TRUE(cell.person.grab("right", {.body = "cube", .point = {0.02, 0.02, 0.02}}));
  ASSERT_TRUE(cell.person.drag("right", {{{0.6, 0.2, 0.3}}, 0.5}));
  cell.run(2);
  EXPECT_LT(size(rotation_between(Pose(), cell.world->pose("cube"))), 0.1);
  EXPECT_LT(size(cell.hand().at - Vec3{0.6, 0.2, 0.3}), 0.01);
}

TEST(Hand, HoldsTheLightestPartsSteadily) {
  for (const double mass : {0.005, 0.02, 0.1, 1.0}) {
    Scene scene = scene_with_cube();
    scene.bodies.back().mass = mass;
    Cell cell(scene);
    ASSERT_TRUE(
        cell.person.grab("right", {.body = "cube", .point = {0.02, 0.02, 0.02}, .stiffness = 5000, .damping = 100}));
    ASSERT_TRUE(cell.person.drag("right", {{{0.5, 0.3, 0.3}}}));
    cell.run(1.5);
    const Vec3 before = cell.cube();
    for (int i = 0; i < 300; ++i) {
      cell.step();
      ASSERT_LT(size(cell.cube() - before), 1e-4) << mass << " kg, step " << i;
    }
  }
}

TEST(Hand, LetsThePartFallWhenItLetsGo) {
  Cell cell;
  ASSERT_TRUE(cell.person.grab("right", {.body = "cube"}));
  ASSERT_TRUE(cell.person.drag("right", {{{0.5, 0.3, 0.2}}}));
  cell.run(1);
  cell.person.release("right");
  cell.run(1);
  EXPECT_NEAR(cell.cube()[2], 0.02, 1e-3);
  EXPECT_TRUE(cell.person.touches().empty());
}

TEST(Hand, ThereIsABoundedNumberOfThemOfPointsToGoToAndOfPushes) {
  Cell cell;
  Person& person = cell.person;
  for (std::size_t i = 0; i < Person::kHands; ++i) ASSERT_TRUE(person.grab(std::to_string(i), {.body = "cube"}));
  EXPECT_EQ(path(person.grab("one more", {.body = "cube"})), "hand");
  EXPECT_TRUE(person.grab("0", {.body = "cube"})) << "it is there";
  Drag drag{std::vector<Vec3>(Drag::kPoints, Vec3{0.5, 0.3, 0.1})};
  EXPECT_TRUE(person.drag("0", drag));
  drag.path.push_back(drag.path.front());
  EXPECT_EQ(code(person.drag("0", drag)), ErrorCode::out_of_range);
  const Push push{"cube", {0.1, 0, 0}, {}, 0.1, 0};
  for (std::size_t i = 0; i < Person::kPushes; ++i) ASSERT_TRUE(person.push(push));
  EXPECT_EQ(code(person.push(push)), ErrorCode::conflict);
  cell.run(0.2);
  EXPECT_TRUE(person.push(push)) << "the others are over";
}

TEST(Hand, OfSomebodyWhoIsGoneLetsGo) {
  Cell cell;
  ASSERT_TRUE(cell.person.grab("right", {.body = "cube"}));
  ASSERT_TRUE(cell.person.keep("right", 0.5));
  cell.run(0.4);
  ASSERT_TRUE(cell.person.drag("right", {{{0.5, 0.3, 0.04}}, 0.1}));  // under way for 0.2 s
  cell.run(0.69);
  EXPECT_FALSE(cell.person.touches().empty());
  cell.run(0.03);
  EXPECT_TRUE(cell.person.touches().empty());
}

TEST(Push, LastsAsLongAsAskedAndRisesEvenly) {
  Cell cell;
  ASSERT_TRUE(cell.person.push({"cube", {0, 0, -20}, {}, 0.5, 0.2}));
  std::vector<double> forces;
  for (int i = 0; i < 600; ++i) {
    cell.step();
    const auto touches = cell.person.touches();
    forces.push_back(touches.empty() ? 0 : -touches.front().second.force[2]);
  }
  EXPECT_NEAR(forces[100], 10, 0.1);
  EXPECT_NEAR(forces[250], 20, 1e-9);
  EXPECT_NEAR(forces[400], 10, 0.1);
  EXPECT_GT(forces[499], 0);
  EXPECT_EQ(forces[500], 0);
}

TEST(Push, AcceleratesAsNewtonSays) {
  Scene scene = scene_with_cube();
  scene.bodies.back().o_t_body.position[2] = 0.5;
  Cell cell(scene);
  ASSERT_TRUE(cell.person.push({"cube", {0, 2, kWeight}, {}, 0.1, 0}));
  cell.run(0.1);
  EXPECT_NEAR(cell.cube()[1] - 0.3, 0.5 * (2 / 0.2) * 0.1 * 0.1, 1e-3);
}

TEST(Person, RefusesWhatNoHandCanDo) {
  Cell cell;
  Person& person = cell.person;
  EXPECT_EQ(code(person.grab("right", {.body = "ghost"})), ErrorCode::not_found);
  EXPECT_EQ(code(person.grab("right", {.body = "table"})), ErrorCode::type);
  EXPECT_EQ(code(person.grab("right", {.body = "base_link"})), ErrorCode::type);
  EXPECT_EQ(path(person.grab("right", {.body = "cube", .point = {0.6, 0, 0}})), "point");
  EXPECT_EQ(path(person.grab("right", {.body = "cube", .point = {NAN, 0, 0}})), "point");
  EXPECT_EQ(path(person.grab("right", {.body = "cube", .stiffness = 5001})), "stiffness");
  EXPECT_EQ(path(person.grab("right", {.body = "cube", .damping = -1})), "damping");
  EXPECT_EQ(path(person.grab("right", {.body = "cube", .force = 251})), "limit");
  EXPECT_EQ(code(person.drag("right", {{{0, 0, 1}}})), ErrorCode::conflict);
  EXPECT_EQ(path(person.push({"cube", {200, 200, 0}, {}, 0.1, 0})), "force");
  EXPECT_EQ(path(person.push({"cube", {NAN, 0, 0}, {}, 0.1, 0})), "force");
  EXPECT_EQ(path(person.push({"cube", {1, 0, 0}, {}, 0, 0})), "duration");
  EXPECT_EQ(path(person.push({"cube", {1, 0, 0}, {}, 0.1, 0.06})), "rise");
  EXPECT_TRUE(person.touches().empty());
  ASSERT_TRUE(person.grab("right", {.body = "cube"}));
  EXPECT_EQ(path(person.drag("right", {{{0, 0, 1}}, 2.5})), "speed");
  EXPECT_EQ(path(person.drag("right", {{}})), "path");
  EXPECT_EQ(path(person.drag("right", {{{0, NAN, 1}}})), "path");
  EXPECT_EQ(path(person.keep("right", NAN)), "keep");
}

}  // namespace
}  // namespace race::world
