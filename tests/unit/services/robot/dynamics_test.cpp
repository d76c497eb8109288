// The control unit's model of the arm against the plant, which is built by another library from the same URDF.
#include <random>

#include "tests/unit/services/robot/rig.h"

namespace race::robot {
namespace {

Joints random_posture(const ArmModel& arm, std::mt19937& random) {
  Joints q;
  for (std::size_t i = 0; i < kJoints; ++i)
    q[i] = std::uniform_real_distribution(0.95 * arm.limits().lower[i], 0.95 * arm.limits().upper[i])(random);
  return q;
}

TEST(ArmModel, PutsTheToolWhereThePlantHasIt) {
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    world::Scene scene = empty_scene();
    scene.robot.o_t_base = {{0.3, -0.2, 0.1}, {0, 0, std::sin(0.4), std::cos(0.4)}};
    const ArmModel arm = make_arm(*Rig::make_world(scene));
    scene.robot.q = random_posture(arm, random);
    const auto world = Rig::make_world(scene);
    const Pose expected = world->pose("tcp");
    EXPECT_LT(distance(arm.forward(scene.robot.q).position, expected.position), 1e-9);
    EXPECT_LT(angle(arm.forward(scene.robot.q), expected), 1e-6);
  }
}

TEST(ArmModel, HasThePublishedLinkLengths) {
  const ArmModel arm = make_arm(*Rig::make_world(empty_scene()));
  const double gripper = 0.15;
  EXPECT_NEAR(arm.forward(Joints{}).position[2], 0.31 + 0.40 + 0.39 + 0.078 + gripper, 1e-12);
  EXPECT_NEAR(arm.reach(), 0.40 + 0.39 + 0.078 + gripper, 1e-12);
  EXPECT_NEAR(arm.shoulder()[2], 0.31, 1e-12);
}

TEST(ArmModel, JacobianIsTheDerivativeOfThePose) {
  std::mt19937 random(2);
  const ArmModel arm = make_arm(*Rig::make_world(empty_scene()));
  const Joints q = random_posture(arm, random);
  const Jacobian jacobian = arm.jacobian(q);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const double h = 1e-6;
    Joints moved = q;
    moved[joint] += h;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double slope = (arm.forward(moved).position[axis] - arm.forward(q).position[axis]) / h;
      EXPECT_NEAR(slope, jacobian[axis][joint], 1e-5);
    }
  }
}

TEST(ArmModel, PredictsThePlantsAcceleration) {
  // From rest under random torques, over one step: M ddq + g = tau. The jaws are made light, as they give way.
  std::mt19937 random(3);
  world::Scene scene = empty_scene();
  world::RobotModel model = *world::load_urdf(scene.robot.urdf);
  for (const int jaw : model.moved_by(world::Joint::Kind::prismatic)) {
    world::Link& finger = model.links[static_cast<std::size_t>(jaw)];
    finger.mass = 1e-4;
    finger.inertia = {1e-7, 1e-7, 1e-7};
  }
  const ArmModel arm = std::move(*ArmModel::create(model, scene.robot.o_t_base));
  for (int i = 0; i < 20; ++i) {
    scene.robot.q = random_posture(arm, random);
    const auto world = std::move(*world::World::create(scene, model));
    Joints torques = arm.gravity(scene.robot.q);
    for (double& torque : torques) torque += std::uniform_real_distribution(-3.0, 3.0)(random);
    world->set_torques(torques);
    world->step();
    Joints acceleration = world->dq();
    for (double& a : acceleration) a /= world::World::kStep;
    const Joints explained = arm.inverse_dynamics(scene.robot.q, Joints{}, acceleration);
    for (std::size_t joint = 0; joint < kJoints; ++joint) EXPECT_NEAR(explained[joint], torques[joint], 5e-3);
  }
}

TEST(GravityCompensation, LetsTheArmFloatWithoutDrift) {
  Rig rig(empty_scene());
  rig.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  const Joints before = rig.world->q();
  rig.run(10);
  for (std::size_t i = 0; i < kJoints; ++i) EXPECT_NEAR(rig.world->q()[i], before[i], 1e-6);
}

TEST(GravityCompensation, YieldsToAHand) {
  Rig rig(empty_scene());
  rig.unit.set_behavior(usual_behavior(Mode::gravity_compensation));
  const double before = rig.world->pose("tcp").position[1];
  rig.each_step = [&] { rig.world->push("gripper", {0, 15, 0}, rig.world->pose("tcp").position); };
  rig.run(1);
  EXPECT_GT(rig.world->pose("tcp").position[1], before + 0.05);
}

TEST(PositionControl, HoldsAgainstAHand) {
  Rig rig(empty_scene());
  const double before = rig.world->pose("tcp").position[1];
  rig.each_step = [&] { rig.world->push("gripper", {0, 15, 0}, rig.world->pose("tcp").position); };
  rig.run(1);
  EXPECT_NEAR(rig.world->pose("tcp").position[1], before, 0.005);
}

TEST(Plant, RunsTwiceTheSameBitForBit) {
  Rig first(demo_scene());
  Rig second(demo_scene());
  const MoveCommand command{.target = down_at(0.5, -0.2, 0.2)};
  ASSERT_TRUE(first.unit.move(command));
  ASSERT_TRUE(second.unit.move(command));
  for (int i = 0; i < 3000; ++i) {
    first.step();
    second.step();
    ASSERT_EQ(first.world->q(), second.world->q()) << "step " << i;
    ASSERT_EQ(first.world->pose("cube_red"), second.world->pose("cube_red")) << "step " << i;
  }
}

}  // namespace
}  // namespace race::robot
