#include "services/world/frames.h"

#include <cmath>

namespace race::world {

Vec3 rotation_between(const Pose& from, const Pose& to) {
  // to * inverse(from), with the sign that gives the shorter way.
  const auto& a = to.orientation;
  const auto& b = from.orientation;
  const Vec3 u{a[0], a[1], a[2]};
  const Vec3 v{b[0], b[1], b[2]};
  Vec3 sine = b[3] * u - a[3] * v - cross(u, v);
  double cosine = a[3] * b[3] + dot(u, v);
  if (cosine < 0) {
    sine = -1.0 * sine;
    cosine = -cosine;
  }
  const double length = std::sqrt(dot(sine, sine));
  if (length < 1e-12) return {};
  return (2 * std::atan2(length, cosine) / length) * sine;
}

}  // namespace race::world
