// Symmetry: the rotations that map a part onto itself, as a group. Two orientations that differ by one are the same.
// Immutable; any thread.
#pragma once

#include <memory>
#include <vector>

#include "services/recognition/part.h"

namespace race::recognition {

class Symmetry {
 public:
  /// The group that `turns` generate.
  explicit Symmetry(const std::vector<RotationalSymmetry>& turns);
  ~Symmetry();
  Symmetry(Symmetry&&) noexcept;

  /// The turns of finite order, the one that turns nothing first.
  std::vector<Quaternion> turns() const;
  /// The least angle [rad] between two orientations, 0 if they are the same.
  double angle(const Quaternion& a, const Quaternion& b) const;
  /// Of the orientations that are the same as `orientation`, the one whose z axis is nearest to `up`, and then whose x
  /// axis is nearest to `right`: so that a part at rest has one orientation.
  Quaternion upright(const Quaternion& orientation, const Vec3& up, const Vec3& right) const;

 private:
  struct Group;
  std::unique_ptr<Group> group_;
};

}  // namespace race::recognition
