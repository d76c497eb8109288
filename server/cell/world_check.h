// What a process that is a cell may say of its world; all else loses it. Pure functions; errors name the field.
#pragma once

#include <set>
#include <string>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

/// What a world that was checked has, by name.
struct WorldNames {
  std::set<std::string, std::less<>> parts;   // bodies that are not fixed
  std::set<std::string, std::less<>> links;   // of its robots
  std::set<std::string, std::less<>> joints;  // of its robots, that move
};

/// {scene: schemas/scene.json, files: URDF texts by name}, each robot with its URDF and no file besides; orientations
/// are unit quaternions. Errors: `type`, `missing`, `unknown_field`, `duplicate`, `out_of_range`, those of read_urdf().
Expected<WorldNames> check_world(const Value& world);

/// schemas/cell_pose.json of this world: its joints, its parts, hands at its links and parts.
Expected<void> check_pose(const WorldNames& world, const Value& pose);

/// schemas/person.json of this world.
Expected<void> check_person(const WorldNames& world, const Value& person);

}  // namespace race::server
