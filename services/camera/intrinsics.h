// Intrinsics: the pinhole of a picture. Pixel (u, v) sees along ((u - cx) / fx, (v - cy) / fy, 1) in the camera's frame
// c: z along the view, x right, y down; pixels are counted from 0, their centres are whole numbers.
#pragma once

#include <cmath>
#include <numbers>

namespace race::camera {

struct Intrinsics {
  int width = 0, height = 0;
  double fx = 0, fy = 0, cx = 0, cy = 0;  // pixels
};

/// A pinhole in the middle of the picture with these fields of view [deg].
inline Intrinsics with_field_of_view(int width, int height, double horizontal, double vertical) {
  const auto focal = [](int pixels, double degrees) {
    return pixels / 2.0 / std::tan(degrees / 2 * std::numbers::pi / 180);
  };
  return {width, height, focal(width, horizontal), focal(height, vertical), (width - 1) / 2.0, (height - 1) / 2.0};
}

/// Microsoft Kinect (first generation), data sheet: 640x480, 57 deg by 43 deg.
inline Intrinsics kinect() { return with_field_of_view(640, 480, 57, 43); }

inline constexpr double kKinectNearest = 0.8;   // m, data sheet
inline constexpr double kKinectFarthest = 4.0;  // m, data sheet

}  // namespace race::camera
