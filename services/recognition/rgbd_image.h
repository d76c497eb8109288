// RgbdImage: depth and colour of one exposure, read from a packet of the flow `camera.frame`
// (services/camera/README.md). A frame in this room is a coordinate frame.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/value/expected.h"
#include "services/component.h"

namespace race::recognition {

struct RgbdImage {
  services::Time time = 0;
  int width = 0, height = 0;
  double fx = 0, fy = 0, cx = 0, cy = 0;            // pixels
  std::vector<std::uint16_t> depth_mm;              // 0: not measured
  std::vector<std::array<std::uint8_t, 3>> colour;  // red, green, blue

  /// Depth [m] at a pixel; 0: not measured, or outside of the picture.
  double depth(int u, int v) const {
    if (u < 0 || v < 0 || u >= width || v >= height) return 0;
    return depth_mm[index(u, v)] / 1000.0;
  }
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
  /// The point seen at a pixel, in the camera's frame [m].
  std::array<double, 3> point(int u, int v) const {
    const double z = depth_mm[index(u, v)] / 1000.0;
    return {(u - cx) / fx * z, (v - cy) / fy * z, z};
  }
};

/// Errors: `missing`, `type`, `out_of_range` (a header that cannot be); `type` for another encoding or
/// number of bytes.
Expected<RgbdImage> read_rgbd_image(const services::Packet& packet);

}  // namespace race::recognition
