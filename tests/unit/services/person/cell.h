// A world with the demonstrator's robot upright, as nobody holds it, the table and one cube; and a person.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "services/world/person.h"

namespace race::world {

inline Scene scene_with_cube() {
  Scene scene = load_scene(RACE_SOURCE_DIR "/deploy/demo/scene.json").value();
  std::erase_if(scene.bodies, [](const Body& body) { return body.mass > 0; });
  scene.robot.q = {};
  scene.bodies.push_back(
      {"cube", {Shape::Kind::box, {0.04, 0.04, 0.04}}, {{0.5, 0.3, 0.02}, {0, 0, 0, 1}}, 0.2, 0.7, "#000000"});
  return scene;
}

struct Cell {
  Cell() : Cell(scene_with_cube()) {}
  explicit Cell(const Scene& scene)
      : world(std::move(World::create(scene, load_urdf(scene.robot.urdf).value()).value())), person(*world) {}

  void step() {
    person.step();
    world->step();
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / World::kStep)); ++i) step();
  }
  Vec3 cube() const { return world->pose("cube").position; }
  Touch hand(const std::string& name = "right") const {
    for (const auto& [hand, touch] : person.touches())
      if (hand == name) return touch;
    ADD_FAILURE() << name << " touches nothing";
    return {};
  }

  std::unique_ptr<World> world;
  Person person;
};

inline double size(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

}  // namespace race::world
