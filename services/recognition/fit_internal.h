// Fitting a part to what was seen: iterative closest points against the part's exact surface, and how well it explains
// the picture.
#pragma once

#include <optional>

#include "services/recognition/cloud.h"
#include "services/recognition/geometry_internal.h"
#include "services/recognition/rgbd_image.h"
#include "services/recognition/symmetry.h"

namespace race::recognition {

/// Points of one colour.
struct ColouredPoints {
  std::uint8_t colour = 0;  // index into the palette
  Points points;
};

/// A part with what fitting needs of it, computed once.
struct Model {
  Part part;
  std::vector<std::uint8_t> colours;  // of each piece, index into the palette
  Symmetry symmetry;
};

/// Standard deviation [m] of a depth of z [m], with its rounding: what a surface may seem to be off.
inline double deviation(double z) { return 1.65e-3 * z * z; }

/// Moves `c_t_x` until the points lie on the surfaces of the pieces of their colour: point to plane, by Gauss and
/// Newton, with far points left out more strictly from step to step.
Transform refine(const Model& model, const std::vector<ColouredPoints>& seen, Transform c_t_x);

/// How well a pose explains what was seen.
struct Fit {
  double inliers = 0;  // share of the points that lie on the surface, within 3 deviations
  double covered = 0;  // share of the surface that should be seen and is, by depth and, beside markers, by colour
  double rms = 0;      // m, of the inliers
  double sunk = 0;     // m that it reaches below the plane that things stand on
  double confidence() const { return inliers * covered; }
};
Fit assess(const Model& model, const std::vector<ColouredPoints>& seen, const Transform& c_t_x, const RgbdImage& image,
           const std::vector<std::uint8_t>& colours, const std::optional<Plane>& plane);

}  // namespace race::recognition
