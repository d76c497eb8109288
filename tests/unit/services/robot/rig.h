// A real Bullet world with the demonstrator's robot and a scene of the test's choice, driven by its control unit.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "services/robot/control_unit.h"
#include "services/world/clearance.h"
#include "services/world/world.h"

namespace race::robot {

inline world::Scene demo_scene() {
  auto scene = world::load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json");
  if (!scene) throw std::runtime_error(to_string(scene.error()));
  return *scene;
}

/// The scene with nothing in reach of the arm.
inline world::Scene empty_scene() {
  world::Scene scene = demo_scene();
  scene.bodies.clear();
  return scene;
}

/// An immovable box along the axes of o, edges and middle in metres.
inline world::Body fixed_box(const std::string& name, const Vec3& edges, const Vec3& middle) {
  world::Body body;
  body.name = name;
  body.shape = {world::Shape::Kind::box, edges};
  body.o_t_body.position = middle;
  return body;
}

inline ArmModel make_arm(const world::World& world) {
  auto arm = ArmModel::create(world.model(), world.scene().robot.o_t_base);
  if (!arm) throw std::runtime_error(to_string(arm.error()));
  return std::move(*arm);
}

struct Rig {
  explicit Rig(const world::Scene& scene)
      : world(make_world(scene)),
        clearance(world->model(), scene),
        unit(make_arm(*world), lwr_settings(), world->q(),
             [this](const Joints& q, double margin) { return clearance.keeps(q, margin); }) {
    world->set_torques(make_arm(*world).gravity(world->q()));
  }

  static std::unique_ptr<world::World> make_world(const world::Scene& scene) {
    auto model = world::load_urdf(scene.robot.urdf);
    if (!model) throw std::runtime_error(to_string(model.error()));
    auto made = world::World::create(scene, *model);
    if (!made) throw std::runtime_error(to_string(made.error()));
    return std::move(*made);
  }

  /// One millisecond: the world moves, then the control unit answers.
  void step() {
    world->step();
    world->set_torques(unit.control(world->q(), world->dq()));
    if (each_step) each_step();
  }

  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 1000)); ++i) step();
  }

  /// Starts a motion that must be accepted and steps until it ends; none: reached.
  std::optional<Refusal> move(const MoveCommand& command, const std::optional<Behavior>& behavior = {}) {
    const auto accepted = unit.move(command, behavior);
    if (!accepted) return accepted.error();
    for (int i = 0; i < 30000; ++i) {
      step();
      if (auto outcome = unit.take_outcome()) return *outcome;
    }
    return Refusal{"test", "", "the motion did not end"};
  }

  std::unique_ptr<world::World> world;
  world::Clearance clearance;
  ControlUnit unit;
  std::function<void()> each_step;
};

inline constexpr int kHoldCycles = 250;  // that a call of jog() or guide() is good for

inline double distance(const Vec3& a, const Vec3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Steps until the tool stands: s until then, and m that it goes.
inline std::pair<double, double> standstill(Rig& rig) {
  const Vec3 from = rig.world->pose("tcp").position;
  double time = 0;
  for (; tool_way(rig.unit.arm(), rig.world->q(), rig.world->dq()) > 0.001; time += ControlUnit::kPeriod) rig.step();
  return {time, distance(from, rig.world->pose("tcp").position)};
}

/// Angle in rad between two orientations.
inline double angle(const Pose& a, const Pose& b) {
  double dot = 0;
  for (std::size_t i = 0; i < 4; ++i) dot += a.orientation[i] * b.orientation[i];
  return 2 * std::acos(std::min(1.0, std::abs(dot)));
}

/// Tool pointing straight down.
inline Pose down_at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

}  // namespace race::robot
