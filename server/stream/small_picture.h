// A picture of a depth camera as browsers get it: small enough for many watchers, and for a store.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "services/component.h"

namespace race::server {

/// Pixels by rows from the top left: of each square of pixels of the camera the mean colour and the first depth that
/// was measured.
struct SmallPicture {
  static constexpr std::size_t kMostWidth = 320;

  std::size_t width = 0, height = 0;
  std::string depth;   // 16 bit little-endian of each pixel, mm; 0: none was measured
  std::string colour;  // red, green, blue of each pixel
};

/// The picture of a packet ("depth16_mm+rgb8", services/camera). Nothing: it has none, its bytes are not as its header
/// says, or it is lower than one square.
std::optional<SmallPicture> small_picture(const services::Packet& packet);

}  // namespace race::server
