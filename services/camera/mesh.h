// Triangles of the shapes that a scene knows. Pure.
#pragma once

#include <array>
#include <vector>

#include "services/world/robot_model.h"

namespace race::camera {

using world::Vec3;

/// Corners in the shape's frame, counter-clockwise seen from outside.
using Triangle = std::array<Vec3, 3>;

/// The surface of `shape`: exact for boxes; round ones are inscribed polyhedra whose faces lie at most 0.5 % of the
/// radius inside.
std::vector<Triangle> mesh(const world::Shape& shape);

}  // namespace race::camera
