// Parts that an experimenter puts elsewhere, takes away and puts back.
#include "services/world/frames.h"
#include "tests/unit/services/person/cell.h"

namespace race::world {
namespace {

Pose at(double x, double y, double z) { return {{x, y, z}, {0, 0, 0, 1}}; }

TEST(Parts, RestWhereTheyArePlaced) {
  Cell cell;
  ASSERT_TRUE(cell.person.place("cube", at(0.7, -0.2, 0.02)));
  cell.run(0.5);
  EXPECT_LT(size(cell.cube() - Vec3{0.7, -0.2, 0.02}), 1e-3);
  EXPECT_NEAR(cell.world->contact_force("cube", "table"), 0.2 * 9.81, 0.02);
}

TEST(Parts, AreNotPutIntoOtherBodies) {
  Cell cell;
  const Vec3 before = cell.cube();
  for (const auto& [pose, inside] :
       {std::pair{at(0.7, -0.2, 0.0), "table"}, {at(0.7, 0, -0.02), "table"}, {at(0, 0, 0.4), "link_2"}}) {
    const auto placed = cell.person.place("cube", pose);
    ASSERT_FALSE(placed) << inside;
    EXPECT_EQ(placed.error().code, ErrorCode::conflict);
    EXPECT_NE(placed.error().message.find(inside), std::string::npos) << placed.error().message;
  }
  EXPECT_EQ(cell.cube(), before);
  EXPECT_TRUE(cell.person.place("cube", at(0.51, 0.3, 0.02))) << "where it is itself is free";
  EXPECT_TRUE(cell.person.place("cube", at(0.7, -0.2, 0.0195))) << "digits of a written pose";
}

TEST(Parts, LinksAndFurnitureArePlacedByNobody) {
  Cell cell;
  const JointArray before = cell.world->q();
  EXPECT_EQ(cell.person.place("link_5", at(1, 1, 1)).error().code, ErrorCode::type);
  EXPECT_EQ(cell.person.take("link_5").error().code, ErrorCode::type);
  EXPECT_EQ(cell.person.take("table").error().code, ErrorCode::type);
  EXPECT_EQ(cell.person.take("ghost").error().code, ErrorCode::not_found);
  EXPECT_EQ(cell.person.place("cube", {}).error().code, ErrorCode::missing);
  EXPECT_EQ(cell.world->q(), before);
}

TEST(Parts, ThatWereTakenAreNotThereUntilTheyArePutBack) {
  Cell cell;
  cell.run(0.1);
  const Vec3 before = cell.cube();
  ASSERT_TRUE(cell.person.grab("right", {.body = "cube"}));
  ASSERT_TRUE(cell.person.take("cube"));
  EXPECT_TRUE(cell.person.touches().empty()) << "the hand is empty";
  EXPECT_FALSE(cell.world->present("cube"));
  EXPECT_EQ(cell.person.take("cube").error().code, ErrorCode::conflict);
  EXPECT_EQ(cell.person.grab("right", {.body = "cube"}).error().code, ErrorCode::conflict);
  EXPECT_EQ(cell.person.push({"cube", {1, 0, 0}, {}, 0.1, 0}).error().code, ErrorCode::conflict);
  cell.run(0.2);
  EXPECT_EQ(cell.world->contact_force("cube", "table"), 0);
  ASSERT_TRUE(cell.person.place("cube", {}));
  EXPECT_TRUE(cell.world->present("cube"));
  cell.run(0.2);
  EXPECT_LT(size(cell.cube() - before), 1e-3);
}

TEST(Parts, AreNotPutBackWhereSomethingElseStands) {
  Scene scene = scene_with_cube();
  scene.bodies.push_back(scene.bodies.back());
  scene.bodies.back().name = "other";
  scene.bodies.back().o_t_body = at(0.7, 0, 0.02);
  Cell cell(scene);
  ASSERT_TRUE(cell.person.take("cube"));
  ASSERT_TRUE(cell.person.place("other", at(0.5, 0.3, 0.02)));
  EXPECT_EQ(cell.person.place("cube", {}).error().code, ErrorCode::conflict);
  EXPECT_FALSE(cell.world->present("cube"));
}

TEST(Parts, MovedTheSameWayMoveTheSameWay) {
  const auto run = [] {
    Cell cell;
    EXPECT_TRUE(cell.person.grab("right", {.body = "cube", .point = {0.01, 0, 0.02}}));
    EXPECT_TRUE(cell.person.drag("right", {{{0.6, 0.1, 0.2}}, 0.7}));
    cell.run(0.3);
    EXPECT_TRUE(cell.person.place("cube", at(0.7, 0.3, 0.1)));
    EXPECT_TRUE(cell.person.push({"cube", {3, 1, 0}, {0.01, 0, 0.01}, 0.05, 0.01}));
    cell.run(0.5);
    return cell.world->pose("cube");
  };
  EXPECT_EQ(run(), run());
}

}  // namespace
}  // namespace race::world
