// View: what a camera in a world has before it, as coloured shapes in its frame.
#pragma once

#include <vector>

#include "services/camera/rasterizer.h"
#include "services/world/world.h"

namespace race::camera {

/// All bodies of the scene that are present, with their markers, and the links of the robot, as they are now, seen from
/// `o_t_c`. On the world's thread.
std::vector<Item> view(const world::World& world, const world::Pose& o_t_c);

}  // namespace race::camera
