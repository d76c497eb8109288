// What a process that is a cell may say of its world; all else loses it. Pure functions; errors name the field.
#pragma once

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

/// {scene: schemas/scene.json, files: URDF texts by name}, each robot with its URDF and no file besides. Errors:
/// `type`, `missing`, `unknown_field`, `duplicate`, `out_of_range`, those of read_urdf().
Expected<void> check_world(const Value& world);

/// schemas/cell_pose.json of a world that was checked.
Expected<void> check_pose(const Value& world, const Value& pose);

/// schemas/person.json of a world that was checked.
Expected<void> check_person(const Value& world, const Value& person);

}  // namespace race::server
