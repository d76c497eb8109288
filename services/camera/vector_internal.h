// The few operations on three numbers that pictures need.
#pragma once

#include <cmath>

#include "services/world/pose.h"

namespace race::camera {

using world::Vec3;

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }

using Quaternion = std::array<double, 4>;  // [qx, qy, qz, qw], of length 1

inline Vec3 rotate(const Quaternion& q, const Vec3& v) {
  const Vec3 axis{q[0], q[1], q[2]};
  const Vec3 twice = 2.0 * cross(axis, v);
  return v + q[3] * twice + cross(axis, twice);
}
inline Quaternion conjugate(const Quaternion& q) { return {-q[0], -q[1], -q[2], q[3]}; }
inline Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

inline Vec3 transform(const world::Pose& a_t_b, const Vec3& in_b) {
  return a_t_b.position + rotate(a_t_b.orientation, in_b);
}
inline world::Pose compose(const world::Pose& a_t_b, const world::Pose& b_t_c) {
  return {transform(a_t_b, b_t_c.position), multiply(a_t_b.orientation, b_t_c.orientation)};
}
inline world::Pose inverse(const world::Pose& a_t_b) {
  const Quaternion back = conjugate(a_t_b.orientation);
  return {-1.0 * rotate(back, a_t_b.position), back};
}

}  // namespace race::camera
