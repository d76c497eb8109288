#include "services/robot/ik.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace race::robot {
namespace {

using Vector7 = Eigen::Matrix<double, 7, 1>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kLargestStep = 0.3;  // rad per iteration and joint
// The pull towards the preferred posture ends here; then the pose alone counts, so that it is met exactly.
constexpr int kNullSpaceIterations = 40;
constexpr int kSpreadSeeds = 40;

Eigen::Quaterniond quaternion(const Pose& pose) {
  const auto& q = pose.orientation;
  return Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
}

/// Position and rotation vector that lead from `from` to `to`, in o.
Vector6 pose_error(const Pose& from, const Pose& to) {
  Vector6 error;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    error(i) = to.position[k] - from.position[k];
  }
  const Eigen::AngleAxisd turn((quaternion(to) * quaternion(from).conjugate()).normalized());
  const double angle = turn.angle() > std::numbers::pi ? turn.angle() - 2 * std::numbers::pi : turn.angle();
  error.tail<3>() = turn.axis() * angle;
  return error;
}

/// Numbers spread evenly over (0, 1) whatever their count (the radical inverse of n in `base`).
double radical_inverse(int n, int base) {
  double result = 0;
  double digit = 1.0;
  for (; n > 0; n /= base) {
    digit /= base;
    result += digit * (n % base);
  }
  return result;
}

Joints spread_seed(const JointLimits& limits, int n) {
  constexpr std::array<int, kJoints> primes = {2, 3, 5, 7, 11, 13, 17};
  Joints seed;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double share = 0.1 + 0.8 * radical_inverse(n, primes[i]);
    seed[i] = limits.lower[i] + share * (limits.upper[i] - limits.lower[i]);
  }
  return seed;
}

}  // namespace

std::optional<Joints> solve_ik_from(const ArmModel& arm, const Pose& target, const Joints& seed,
                                    const IkOptions& options) {
  const JointLimits& limits = arm.limits();
  Joints q = seed;
  const Eigen::Map<const Vector7> preferred(options.preferred.data());
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const Vector6 error = pose_error(arm.forward(q), target);
    const double position = error.head<3>().norm();
    const double orientation = error.tail<3>().norm();
    if (position < options.position_tolerance && orientation < options.orientation_tolerance) return q;

    const Jacobian rows = arm.jacobian(q);
    const Eigen::Map<const Eigen::Matrix<double, 6, 7, Eigen::RowMajor>> jacobian(rows[0].data());
    // Damping fades with the error: robust far away and near singularities, quadratic at the end.
    const double damping = 1e-8 + 1e-2 * std::min(1.0, error.squaredNorm());
    const Eigen::Matrix<double, 6, 6> gram =
        jacobian * jacobian.transpose() + damping * Eigen::Matrix<double, 6, 6>::Identity();
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> solver(gram);
    Vector7 step = jacobian.transpose() * solver.solve(error);
    const double gain = iteration < kNullSpaceIterations ? options.null_space_gain : 0.0;
    const Vector7 pull = gain * (preferred - Eigen::Map<const Vector7>(q.data()));
    step += pull - jacobian.transpose() * solver.solve(jacobian * pull);

    const double largest = step.cwiseAbs().maxCoeff();
    if (largest > kLargestStep) step *= kLargestStep / largest;
    for (std::size_t i = 0; i < kJoints; ++i) {
      q[i] = std::clamp(q[i] + step(static_cast<Eigen::Index>(i)), limits.lower[i] + options.margin,
                        limits.upper[i] - options.margin);
    }
  }
  return std::nullopt;
}

std::optional<Joints> solve_ik(const ArmModel& arm, const Pose& target, const Joints& current, const IkOptions& options,
                               const std::function<bool(const Joints&)>& accept) {
  const auto from = [&](const Joints& seed) {
    auto found = solve_ik_from(arm, target, seed, options);
    if (found && accept && !accept(*found)) found.reset();
    return found;
  };
  if (auto found = from(current)) return found;
  Joints turned = options.preferred;
  turned[0] = std::atan2(target.position[1] - arm.shoulder()[1], target.position[0] - arm.shoulder()[0]);
  if (auto found = from(turned)) return found;
  for (int n = 1; n <= kSpreadSeeds; ++n) {
    if (auto found = from(spread_seed(arm.limits(), n))) return found;
  }
  return std::nullopt;
}

}  // namespace race::robot
