#include "tests/bench/robot/cell.h"

#include <stdexcept>

namespace race::robot {

Cell::Cell(bool column) {
  world::Scene scene = world::load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json").value();
  scene.bodies.clear();
  const world::RobotModel model = world::load_urdf(scene.robot.urdf).value();
  if (column) {
    const double x = world::World::create(scene, model).value()->pose("tcp").position[0];
    world::Body body;
    body.name = "column";
    body.shape = {world::Shape::Kind::box, {0.05, 0.05, 1.0}};
    body.o_t_body.position = {x, kFace + 0.025, 0.3};
    scene.bodies.push_back(body);
  }
  world = world::World::create(scene, model).value();
  auto arm = ArmModel::create(world->model(), scene.robot.o_t_base);
  unit = std::make_unique<ControlUnit>(std::move(arm.value()), lwr_settings(), world->q());
}

void Cell::approach(const Behavior& behavior) {
  const double way = 2 * (kFace - side());
  const auto accepted =
      unit->move({.target = Offset{{0, way, 0}}, .kind = MotionKind::linear, .speed = 1, .acceleration = 1}, behavior);
  if (!accepted) throw std::runtime_error(accepted.error().message);
}

double Cell::force_on_column() const {
  double force = 0;
  for (const char* link : {"gripper", "finger_left", "finger_right"}) force += world->contact_force(link, "column");
  return force;
}

}  // namespace race::robot
