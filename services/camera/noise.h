// Noise: from an ideal picture to what a Kinect measures of it.
//
// Depth: the sensor measures disparity, in steps that are 2.85 mm of depth at 1 m and grow with the square of the
// distance, with a standard deviation of half a step: 1.4 mm at 1 m, 5.7 mm at 2 m (Khoshelham, Elberink, "Accuracy and
// resolution of Kinect depth data for indoor mapping applications", Sensors 12, 2012: sigma_z = 1.425e-3 z^2 [m]).
// No measurement beyond the range, on surfaces slanted more than about 80 degrees (certainly above 85, never below 70),
// and at every second pixel beside an edge in depth (Nguyen, Izadi, Lovell, "Modeling Kinect sensor noise for improved
// 3D reconstruction and tracking", 3DIMPVT 2012, describe both). Noise of neighbours is independent, and there is no
// shadow of the projector: both differ from a real Kinect.
// Colour: a standard deviation of 2 of 255 in each channel.
#pragma once

#include <cstdint>
#include <vector>

#include "services/camera/rasterizer.h"

namespace race::camera {

/// A picture as measured: depth in whole millimetres, 0 where there is no measurement.
struct Measurement {
  int width = 0, height = 0;
  std::vector<std::uint16_t> depth_mm;
  std::vector<Rgb> colour;
};

/// What is measured of `picture`; the same `seed` gives the same.
Measurement measure(const Picture& picture, std::uint64_t seed);

}  // namespace race::camera
