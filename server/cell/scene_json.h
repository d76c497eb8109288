// A world as viewers see it: schemas/scene.json and schemas/cell_pose.json.
#pragma once

#include "core/value/value.h"
#include "services/clock.h"
#include "services/world/world.h"

namespace race::server {

/// What does not change: the robot's URDF (a file below /api/v1/cell), shapes and colours of the bodies. Frozen.
Value scene_json(const world::World& world);

/// What moves: joints, and the bodies that are not fixed.
Value pose_json(const world::World& world, services::Time time);

}  // namespace race::server
