// The tool runs into a rigid column: what happens, and how its motion ends.
#pragma once

#include <vector>

#include "tests/unit/services/robot/rig.h"

namespace race::robot {

inline Behavior behavior_with(Mode mode, std::vector<Reflex> reflexes) {
  Behavior behavior = usual_behavior(mode);
  behavior.reflexes = std::move(reflexes);
  return behavior;
}

inline Behavior position_with(std::vector<Reflex> reflexes) {
  return behavior_with(Mode::position, std::move(reflexes));
}

/// A rigid column, 5 cm thick, that the tool meets when it moves sideways along y from its start.
inline world::Scene column_scene() {
  world::Scene scene = empty_scene();
  const double x = Rig(empty_scene()).world->pose("tcp").position[0];
  scene.bodies.push_back(fixed_box("column", {0.05, 0.05, 1.0}, {x, 0.35, 0.3}));
  return scene;
}

/// Sends the tool into the column and steps until the motion has ended; its failure.
struct Crash {
  Rig rig{column_scene()};
  std::optional<Refusal> failure;
  std::vector<Incident> incidents;
  double speed = 0.4;
  double met = 0;  // m, where the tool was when it met the column

  void run(const std::optional<Behavior>& behavior = {}) {
    const auto accepted =
        rig.unit.move({.target = Offset{{0, 0.5, 0}}, .kind = MotionKind::linear, .speed = speed}, behavior);
    ASSERT_TRUE(accepted) << accepted.error().message;
    for (int i = 0; i < 20000; ++i) {
      rig.step();
      for (const Incident& incident : rig.unit.take_incidents()) incidents.push_back(incident);
      if (incidents.empty()) met = tool();
      if (auto outcome = rig.unit.take_outcome()) {
        failure = *outcome;
        return;
      }
    }
    FAIL() << "the motion did not end";
  }
  double force() {
    double sum = 0;
    for (const char* link : {"gripper", "finger_left", "finger_right"}) sum += rig.world->contact_force(link, "column");
    return sum;
  }
  double tool() const { return rig.world->pose("tcp").position[1]; }
};

}  // namespace race::robot
