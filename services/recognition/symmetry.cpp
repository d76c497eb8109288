#include "services/recognition/symmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "services/recognition/geometry_internal.h"

namespace race::recognition {
namespace {

constexpr std::size_t kMostTurns = 120;  // no finite group of a part that we know has more

double angle_of(const Rotation& r) { return Eigen::AngleAxisd(r).angle(); }

Quaternion to_quaternion(const Rotation& r) {
  Eigen::Quaterniond q(r);
  q.normalize();
  return {q.x(), q.y(), q.z(), q.w()};
}

}  // namespace

struct Symmetry::Group {
  std::vector<Rotation> turns{Rotation::Identity()};  // the finite ones
  std::vector<Vector> axes;                           // about which any angle is one; two: all turns are

  bool knows(const Rotation& turn) const {
    return std::ranges::any_of(turns, [&](const Rotation& each) { return angle_of(each.transpose() * turn) < 1e-3; });
  }
};

Symmetry::Symmetry(const std::vector<RotationalSymmetry>& turns) : group_(std::make_unique<Group>()) {
  std::vector<Rotation> generators;
  for (const RotationalSymmetry& turn : turns) {
    const Vector axis = to_eigen(turn.axis);
    if (turn.order == 0) {
      const auto parallel = [&](const Vector& other) { return std::abs(axis.dot(other)) > 1 - 1e-6; };
      if (std::ranges::none_of(group_->axes, parallel)) group_->axes.push_back(axis);
    } else {
      generators.emplace_back(Eigen::AngleAxisd(2 * std::numbers::pi / turn.order, axis).toRotationMatrix());
    }
  }
  for (std::size_t i = 0; i < group_->turns.size() && group_->turns.size() < kMostTurns; ++i) {
    for (const Rotation& generator : generators) {
      const Rotation product = group_->turns[i] * generator;
      if (!group_->knows(product)) group_->turns.push_back(product);
    }
  }
}

Symmetry::~Symmetry() = default;
Symmetry::Symmetry(Symmetry&&) noexcept = default;

std::vector<Quaternion> Symmetry::turns() const {
  std::vector<Quaternion> turns;
  for (const Rotation& turn : group_->turns) turns.push_back(to_quaternion(turn));
  return turns;
}

double Symmetry::angle(const Quaternion& a, const Quaternion& b) const {
  if (group_->axes.size() > 1) return 0;
  const Rotation first = rotation(a), second = rotation(b);
  double least = std::numeric_limits<double>::infinity();
  for (const Rotation& turn : group_->turns) {
    if (group_->axes.empty()) {
      least = std::min(least, angle_of(first.transpose() * second * turn));
    } else {
      // Only where the axis points makes a difference.
      const Vector& axis = group_->axes.front();
      const Vector u = first * axis, v = second * turn * axis;
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  }
  return least;
}

Quaternion Symmetry::upright(const Quaternion& orientation, const Vec3& up, const Vec3& right) const {
  const Vector to_up = to_eigen(up), to_right = to_eigen(right);
  if (group_->axes.size() > 1) {
    const Vector x = (to_right - to_right.dot(to_up) * to_up).normalized();
    Rotation r;
    r << x, to_up.cross(x), to_up;
    return to_quaternion(r);
  }
  const Rotation measured = rotation(orientation);
  Rotation best = measured;
  double best_up = -2, best_right = -2;
  for (const Rotation& turn : group_->turns) {
    Rotation candidate = measured * turn;
    if (!group_->axes.empty()) {
      // Turned about its axis until the x axis, or what stands for it, looks to the right.
      const Vector axis = candidate * group_->axes.front();
      const Vector x = candidate.col(0) - candidate.col(0).dot(axis) * axis;
      const Vector goal = to_right - to_right.dot(axis) * axis;
      if (x.norm() > 0.1 && goal.norm() > 0.1) {
        const double by = std::atan2(axis.dot(x.cross(goal)), x.dot(goal));
        candidate = Eigen::AngleAxisd(by, axis).toRotationMatrix() * candidate;
      }
    }
    const double candidate_up = candidate.col(2).dot(to_up), candidate_right = candidate.col(0).dot(to_right);
    constexpr double kSame = 0.05;  // noise must not choose between two that lie equally well
    if (candidate_up > best_up + kSame || (candidate_up > best_up - kSame && candidate_right > best_right)) {
      best = candidate;
      best_up = candidate_up;
      best_right = candidate_right;
    }
  }
  return to_quaternion(best);
}

}  // namespace race::recognition
