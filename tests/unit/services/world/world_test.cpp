// The plant alone: physics that pencil and paper can check.
#include "services/world/world.h"

#include <gtest/gtest.h>

#include <cmath>

namespace race::world {
namespace {

Scene demo_scene() { return load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json").value(); }

std::unique_ptr<World> make(const Scene& scene) {
  return std::move(World::create(scene, load_urdf(scene.robot.urdf).value()).value());
}

/// The demo's robot and one more body than the table: `part`.
Scene scene_with(const Body& part) {
  Scene scene = demo_scene();
  std::erase_if(scene.bodies, [](const Body& body) { return body.mass > 0; });
  scene.bodies.push_back(part);
  return scene;
}

/// The demo with its arm balanced upright, as nobody holds it.
Scene undisturbed_scene() {
  Scene scene = demo_scene();
  scene.robot.q = {};
  return scene;
}

void run(World& world, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(seconds / World::kStep)); ++i) world.step();
}

TEST(World, CountsItsTimeInSteps) {
  const auto world = make(demo_scene());
  run(*world, 0.25);
  EXPECT_EQ(world->steps(), 250);
  EXPECT_DOUBLE_EQ(world->time(), 0.25);
}

TEST(World, LetsAPartFallAsGalileoSays) {
  const auto world = make(
      scene_with({"part", {Shape::Kind::sphere, {0.02, 0, 0}}, {{0.5, 0.4, 1}, {0, 0, 0, 1}}, 0.1, 0.5, "#000000"}));
  run(*world, 0.3);
  EXPECT_NEAR(world->pose("part").position[2], 1 - 0.5 * 9.81 * 0.3 * 0.3, 2e-3);
}

TEST(World, LetsPartsRestOnTheTable) {
  const auto world = make(undisturbed_scene());
  const Pose before = world->pose("cube_blue");
  run(*world, 2);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(world->pose("cube_blue").position[i], before.position[i], 2e-4);
  EXPECT_NEAR(world->contact_force("cube_blue", "table"), 0.2 * 9.81, 0.02);
}

TEST(World, SlidesAPushedPartBeyondFrictionOnly) {
  // 0.2 kg on a pair with 0.7 * 0.8: it takes 1.10 N to move it.
  for (const auto& [force, slides] : {std::pair{0.9, false}, std::pair{1.4, true}}) {
    const auto world = make(undisturbed_scene());
    run(*world, 0.2);
    const Vec3 before = world->pose("cube_blue").position;
    for (int i = 0; i < 500; ++i) {
      const Vec3 at = world->pose("cube_blue").position;
      world->push("cube_blue", {0, force, 0}, {at[0], at[1], 0.003});
      world->step();
    }
    EXPECT_EQ(world->pose("cube_blue").position[1] > before[1] + 0.01, slides) << force << " N";
  }
}

/// Two cubes of 4 cm, one on the other, at rest for so long that nothing is computed for them any more.
std::unique_ptr<World> resting_pile() {
  Scene scene = undisturbed_scene();
  std::erase_if(scene.bodies, [](const Body& body) { return body.mass > 0; });
  for (const auto& [name, z] : {std::pair{"lower", 0.02}, std::pair{"upper", 0.06}})
    scene.bodies.push_back(
        {name, {Shape::Kind::box, {0.04, 0.04, 0.04}}, {{0.5, 0.3, z}, {0, 0, 0, 1}}, 0.2, 0.7, "#000000"});
  auto world = make(scene);
  run(*world, 4);
  const Pose at_rest = world->pose("upper");
  run(*world, 1);
  EXPECT_EQ(world->pose("upper").position, at_rest.position);
  return world;
}

TEST(World, LetsARestingPartFallWhenWhatItRestsOnIsTaken) {
  const auto world = resting_pile();
  ASSERT_TRUE(world->take("lower"));
  run(*world, 0.5);
  EXPECT_NEAR(world->pose("upper").position[2], 0.02, 1e-3);
}

TEST(World, LetsARestingPartFallWhenWhatItRestsOnIsPlacedElsewhere) {
  const auto world = resting_pile();
  ASSERT_TRUE(world->place("lower", {{0.5, -0.3, 0.02}, {0, 0, 0, 1}}));
  run(*world, 0.5);
  EXPECT_NEAR(world->pose("upper").position[2], 0.02, 1e-3);
}

TEST(World, MovesARestingPartThatIsPushed) {
  const auto world = resting_pile();
  for (int i = 0; i < 300; ++i) {
    world->push("lower", {0, 6, 0}, world->pose("lower").position);
    world->step();
  }
  EXPECT_GT(world->pose("lower").position[1], 0.31);
}

TEST(World, StopsJointsAtTheirEnds) {
  Scene scene = demo_scene();
  scene.bodies.clear();
  const auto world = make(scene);
  double farthest = 0;
  for (int i = 0; i < 4000; ++i) {
    world->set_torques({50, 0, 0, 0, 0, 0, 0});
    world->step();
    farthest = std::max(farthest, world->q()[0]);
  }
  const double end = 170 * M_PI / 180;
  EXPECT_GT(farthest, end - 0.05);
  EXPECT_LT(farthest, end + 0.05);
}

TEST(World, SaturatesTorques) {
  const auto world = make(demo_scene());
  world->set_torques({500, -500, 500, -500, 500, -500, 500});
  EXPECT_EQ(world->torques(), (JointArray{176, -176, 100, -100, 100, -38, 38}));
}

TEST(World, KeepsTheJawsInStep) {
  Scene scene = demo_scene();
  scene.bodies.clear();
  scene.robot.q = {0, 0, 0, 0, 0, M_PI / 2, M_PI / 2};  // gravity pulls along the jaws' way
  const auto world = make(scene);
  world->set_gripper_force(-20);
  run(*world, 0.02);
  const auto offset = [&](const char* finger) {
    const Vec3 a = world->pose("gripper").position;
    const Vec3 b = world->pose(finger).position;
    return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  };
  EXPECT_NEAR(offset("finger_left"), offset("finger_right"), 1e-3);
}

TEST(World, ClosesTheGripperWithinItsStroke) {
  const auto world = make(demo_scene());
  world->set_gripper_force(80);
  run(*world, 1);
  EXPECT_NEAR(world->gripper_width(), 0, 1e-3);
  world->set_gripper_force(-80);
  run(*world, 1);
  EXPECT_NEAR(world->gripper_width(), 0.110, 1e-3);
}

TEST(World, IsAfterAResetAsANewOneButForItsTime) {
  const auto used = make(demo_scene()), fresh = make(demo_scene());
  used->set_torques({20, 20, 0, 0, 0, 0, 0});
  used->set_gripper_force(20);
  used->set_friction("cube_blue", 0.1);
  run(*used, 0.3);
  ASSERT_TRUE(used->take("cube_blue"));
  used->push("cube_red", {5, 0, 0}, used->pose("cube_red").position);
  used->reset();
  EXPECT_EQ(used->steps(), 300);
  EXPECT_TRUE(used->present("cube_blue"));
  for (World* world : {used.get(), fresh.get()}) run(*world, 0.2);
  EXPECT_EQ(used->q(), fresh->q());
  EXPECT_EQ(used->gripper_width(), fresh->gripper_width());
  EXPECT_FALSE(used->braked()) << "no torques were set in this plant";
  for (const Body& body : used->scene().bodies) EXPECT_EQ(used->pose(body.name), fresh->pose(body.name)) << body.name;
}

TEST(World, RefusesWhatCannotBeBuilt) {
  const Scene scene = demo_scene();
  const RobotModel model = load_urdf(scene.robot.urdf).value();
  Scene bent = scene;
  bent.robot.q[1] = 2.5;
  EXPECT_EQ(World::create(bent, model).error().code, ErrorCode::out_of_range);
  Scene wide = scene;
  wide.robot.width = 0.2;
  EXPECT_EQ(World::create(wide, model).error().code, ErrorCode::out_of_range);
  Scene twice = scene;
  twice.bodies[0].name = "link_3";
  EXPECT_EQ(World::create(twice, model).error().code, ErrorCode::duplicate);
  RobotModel short_arm = model;
  short_arm.links.resize(5);
  EXPECT_EQ(World::create(scene, short_arm).error().code, ErrorCode::type);
}

}  // namespace
}  // namespace race::world
