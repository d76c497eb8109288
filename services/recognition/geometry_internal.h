// Eigen's types under the names of this folder, for its .cpp files. x is a part's frame, c the camera's.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "services/recognition/part.h"

namespace race::recognition {

using Vector = Eigen::Vector3d;
using Rotation = Eigen::Matrix3d;
using Transform = Eigen::Isometry3d;
using Points = std::vector<Vector>;

inline Vector to_eigen(const Vec3& v) { return {v[0], v[1], v[2]}; }
inline Rotation rotation(const Quaternion& q) { return Eigen::Quaterniond(q[3], q[0], q[1], q[2]).toRotationMatrix(); }
inline Transform to_eigen(const Pose& pose) {
  return Eigen::Translation3d(to_eigen(pose.position)) * Eigen::Quaterniond(rotation(pose.orientation));
}
inline Pose from_eigen(const Transform& transform) {
  const Vector p = transform.translation();
  Eigen::Quaterniond q(transform.linear());
  q.normalize();
  return {{p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

}  // namespace race::recognition
