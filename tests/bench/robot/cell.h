// A cell with nothing but the robot and, if wanted, a rigid column that the gripper's side meets when the tool moves
// along +y from where it starts.
#pragma once

#include <memory>

#include "services/robot/control_unit.h"
#include "services/world/world.h"

namespace race::robot {

/// The demonstrator's robot on the Bullet world, driven by its control unit. Throws what a broken scene throws.
struct Cell {
  static constexpr double kFace = 0.30;          // m, y of the side of the body that the gripper meets
  static constexpr double kHalfGripper = 0.073;  // m, from the tool's axis to the gripper's side

  explicit Cell(bool column);

  /// One millisecond: the world moves, then the control unit answers.
  void step() {
    world->step();
    world->set_torques(unit->control(world->q(), world->dq()));
  }
  /// Sends the tool along +y on a straight line whose middle, where it is fastest, is at kFace. The move is accepted,
  /// else it throws.
  void approach(const Behavior& behavior);

  /// y of the gripper's side, m.
  double side() const { return world->pose("tcp").position[1] + kHalfGripper; }
  /// What the gripper exerts on the column, N.
  double force_on_column() const;

  std::unique_ptr<world::World> world;
  std::unique_ptr<ControlUnit> unit;
};

}  // namespace race::robot
