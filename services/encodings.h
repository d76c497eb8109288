// Encodings of packets: what the field `encoding` of a header says of the bytes behind it. Services that write such
// packets and those that read them have no other header in common. The layouts are in services/camera/README.md.
#pragma once

#include <string_view>

namespace race::services {

/// Depth, 16 bit little-endian in mm, of every pixel; then red, green, blue of every pixel.
inline constexpr std::string_view kDepthAndColour = "depth16_mm+rgb8";
/// x, y, z of every point, floats of 32 bit little-endian in m; then red, green, blue of every point.
inline constexpr std::string_view kPointsAndColour = "xyz32f_m+rgb8";

}  // namespace race::services
