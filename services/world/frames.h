// Points and directions in two frames: what Pose says, done.
#pragma once

#include "services/world/pose.h"

namespace race::world {

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 operator*(double factor, const Vec3& v) { return {factor * v[0], factor * v[1], factor * v[2]}; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A direction of the inner frame, seen from the outer one.
inline Vec3 turn(const Pose& outer_t_inner, const Vec3& direction) {
  const auto& q = outer_t_inner.orientation;
  const Vec3 axis{q[0], q[1], q[2]};
  const Vec3 twice = 2.0 * cross(axis, direction);
  return direction + q[3] * twice + cross(axis, twice);
}

/// A point of the inner frame, seen from the outer one.
inline Vec3 transform(const Pose& outer_t_inner, const Vec3& point) {
  return outer_t_inner.position + turn(outer_t_inner, point);
}

/// The way from one orientation to another as axis times angle [rad, at most pi], seen from the frame of both.
Vec3 rotation_between(const Pose& from, const Pose& to);

}  // namespace race::world
