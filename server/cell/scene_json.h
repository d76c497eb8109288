// A world as viewers see it: schemas/scene.json, schemas/cell_pose.json and schemas/person.json.
#pragma once

#include "core/value/value.h"
#include "services/clock.h"
#include "services/world/person.h"
#include "services/world/world.h"

namespace race::server {

/// What does not change: the robot's URDF (a file below /api/v1/cell), shapes and colours of the bodies. Frozen.
Value scene_json(const world::World& world);

/// What moves: joints, the bodies that are not fixed and not taken away, and hands.
Value pose_json(const world::World& world, const world::Person& person, services::Time time);

/// What hands hold and pushes touch, and the bodies that were taken away.
Value person_json(const world::World& world, const world::Person& person);

}  // namespace race::server
