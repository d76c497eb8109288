// Pixels: what OpenCV does for recognition: which colour of a palette a pixel has, and the rectangle around a
// footprint. Functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "services/recognition/rgbd_image.h"

namespace race::recognition {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

inline constexpr std::uint8_t kNoColour = 255;

/// For each pixel the index of the colour in `palette` (at most 254 of them) that it has: the one of nearest hue, if
/// that is within 10 degrees and the pixel is colourful; else kNoColour. Light and shadow make no difference.
std::vector<std::uint8_t> classify(const RgbdImage& image, const std::vector<Colour>& palette);

/// A rectangle in a plane: its middle, the direction [rad] of its first edge, and its edges.
struct Rectangle {
  double x = 0, y = 0, angle = 0, length = 0, width = 0;
};

/// The smallest rectangle around the points. Requires at least one.
Rectangle smallest_rectangle(const std::vector<std::array<double, 2>>& points);

}  // namespace race::recognition
