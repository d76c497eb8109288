// The printed markers of bodies as shapes. Pure.
#pragma once

#include <vector>

#include "services/camera/rasterizer.h"
#include "services/world/scene.h"

namespace race::camera {

/// Adds what is seen of a marker on a body at `c_t_body`: a black label, 0.1 mm high, and on it its white cells.
void add_marker(const world::Marker& marker, const world::Pose& c_t_body, std::vector<Item>& items);

}  // namespace race::camera
