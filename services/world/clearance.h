// Clearance: whether the robot would keep its distance from the fixed bodies of a scene, and from itself, with its arm
// at given joint positions. Geometry alone: nothing moves; the world's parts, which can be moved, do not count.
//
// Threads: one at a time.
#pragma once

#include <array>
#include <memory>

#include "services/world/robot_model.h"
#include "services/world/scene.h"

namespace race::world {

class Clearance {
 public:
  /// Links with fewer than three arm joints between them cannot meet within the joints' limits and are not compared,
  /// nor is the fixed root with the fixed bodies. The jaws count as open. Requires a model that World::create takes.
  Clearance(const RobotModel& model, const Scene& scene);
  ~Clearance();
  Clearance(const Clearance&) = delete;
  Clearance& operator=(const Clearance&) = delete;

  /// Whether every pair is at least `margin` [m] apart with the arm at `q` [rad].
  bool keeps(const std::array<double, 7>& q, double margin);

 private:
  struct Geometry;
  std::unique_ptr<Geometry> geometry_;  // Bullet's objects, known to clearance.cpp alone
};

}  // namespace race::world
