// Rasterizer: an ideal picture of coloured shapes: for each pixel the depth along z, the colour, and how slanted the
// surface is to the ray. In software: no GPU, and the same bits on every run.
//
// Threads: a function of its arguments.
#pragma once

#include <cstdint>
#include <vector>

#include "services/camera/intrinsics.h"
#include "services/world/robot_model.h"

namespace race::camera {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// "#rrggbb" as a colour. Requires such a text.
Rgb parse_colour(const std::string& text);

/// A shape as the camera sees it.
struct Item {
  world::Shape shape;
  world::Pose c_t_shape;
  Rgb colour;
};

/// Rows from the top, pixels from the left.
struct Picture {
  int width = 0, height = 0;
  std::vector<float> depth;   // m along z; 0: nothing there
  std::vector<float> facing;  // cosine of the angle between surface normal and ray, 0..1
  std::vector<Rgb> colour;
};

/// Nothing nearer than this is drawn.
inline constexpr double kNearPlane = 0.05;  // m

Picture rasterize(const std::vector<Item>& items, const Intrinsics& intrinsics);

}  // namespace race::camera
