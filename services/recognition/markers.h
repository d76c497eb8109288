// Markers: the printed squares (services/marker.h) in a region of a picture. OpenCV's aruco module reads them;
// no other file includes it. A function; any thread; the same picture gives the same answer.
#pragma once

#include <array>
#include <vector>

#include "services/recognition/rgbd_image.h"

namespace race::recognition {

/// Pixels from (left, top) up to, not including, (right, bottom).
struct Region {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// A point of the picture [pixels].
using ImagePoint = std::array<double, 2>;

struct SeenMarker {
  int id = 0;
  std::array<ImagePoint, 4> corners{};  // of the black square, clockwise from the top left of what is printed
};

/// The markers of services::kMarkerDictionary that lie wholly in the region. The region may reach out of the picture.
std::vector<SeenMarker> find_markers(const RgbdImage& image, Region region);

}  // namespace race::recognition
