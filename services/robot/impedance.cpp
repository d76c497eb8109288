#include "services/robot/impedance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace race::robot {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix7 = Eigen::Matrix<double, 7, 7>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix67 = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;

constexpr double kNullStiffness = 20;    // Nm/rad, towards the reference's posture
constexpr double kSingular = 1e-3;       // 1/kg, added to the tool's mobility, which loses rank in singular postures
constexpr double kLimitStiffness = 800;  // Nm/rad

Eigen::Map<const Vector7> vector(const Joints& joints) { return Eigen::Map<const Vector7>(joints.data()); }

Matrix7 mass_of(const ArmModel& arm, const Joints& q) {
  const MassMatrix rows = arm.mass(q);
  return Eigen::Map<const Eigen::Matrix<double, 7, 7, Eigen::RowMajor>>(rows[0].data());
}

/// D with which each mode of M, K has the damping ratio: M = Q Q^T, K = Q diag(k) Q^T, D = 2 ratio Q diag(sqrt k) Q^T.
template <typename Matrix>
Matrix damping_of(const Matrix& mass, const Matrix& stiffness, double ratio) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> modes(stiffness, mass);
  const Matrix q = mass * modes.eigenvectors();
  const auto roots = modes.eigenvalues().cwiseMax(0.0).cwiseSqrt().eval();
  return 2 * ratio * q * roots.asDiagonal() * q.transpose();
}

Vector6 way_to(const Pose& from, const Pose& to) {
  Vector6 way;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    way(i) = to.position[k] - from.position[k];
  }
  const auto quaternion = [](const Pose& pose) {
    const auto& q = pose.orientation;
    return Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
  };
  const Eigen::AngleAxisd turn((quaternion(to) * quaternion(from).conjugate()).normalized());
  const double angle = turn.angle() > std::numbers::pi ? turn.angle() - 2 * std::numbers::pi : turn.angle();
  way.tail<3>() = turn.axis() * angle;
  return way;
}

/// Torques as they are for the motion of the reference at the measured place: M ddq_d + C dq + g.
Vector7 feed_forward(const ArmModel& arm, const Joints& q, const Joints& dq, const Reference& reference) {
  const Joints torques = arm.inverse_dynamics(q, dq, reference.ddq);
  return vector(torques);
}

Joints joints(const Vector7& torques) {
  Joints out;
  Eigen::Map<Vector7>(out.data()) = torques;
  return out;
}

}  // namespace

Joints joint_impedance(const ArmModel& arm, const Operational& behavior, const Joints& q, const Joints& dq,
                       const Reference& reference) {
  const Matrix7 stiffness = vector(behavior.joint_stiffness).asDiagonal();
  const Matrix7 damping = damping_of<Matrix7>(mass_of(arm, q), stiffness, behavior.damping);
  return joints(stiffness * (vector(reference.q) - vector(q)) + damping * (vector(reference.dq) - vector(dq)) +
                feed_forward(arm, q, dq, reference));
}

Joints cartesian_impedance(const ArmModel& arm, const Operational& behavior, const Joints& q, const Joints& dq,
                           const Reference& reference) {
  const Jacobian rows = arm.jacobian(q);
  const Eigen::Map<const Matrix67> jacobian(rows[0].data());
  const Matrix7 mass = mass_of(arm, q);
  const Eigen::LLT<Matrix7> mass_solver(mass);
  const Eigen::Matrix<double, 7, 6> mobility = mass_solver.solve(jacobian.transpose());  // M^-1 J^T
  const Matrix6 tool_mobility = jacobian * mobility + kSingular * Matrix6::Identity();
  const Matrix6 tool_mass = tool_mobility.inverse();
  const Matrix6 stiffness = Eigen::Map<const Vector6>(behavior.tool_stiffness.data()).asDiagonal();
  const Matrix6 damping = damping_of<Matrix6>((tool_mass + tool_mass.transpose()) / 2, stiffness, behavior.damping);

  const Vector7 speed_error = vector(reference.dq) - vector(dq);
  Vector6 spring = stiffness * way_to(arm.forward(q), arm.forward(reference.q));
  const double pull = spring.head<3>().norm();
  if (behavior.force && pull > *behavior.force) spring.head<3>() *= *behavior.force / pull;
  const Vector6 wrench = spring + damping * (jacobian * speed_error);

  const Vector7 null_damping = 2 * behavior.damping * (kNullStiffness * mass.diagonal()).cwiseSqrt();
  const Vector7 posture = kNullStiffness * (vector(reference.q) - vector(q)) + null_damping.cwiseProduct(speed_error);
  const Vector7 redundant = posture - jacobian.transpose() * (tool_mass * (mobility.transpose() * posture));
  return joints(jacobian.transpose() * wrench + redundant + feed_forward(arm, q, dq, reference));
}

Joints limit_cushions(const ArmModel& arm, const Joints& q, const Joints& dq, const Joints& home) {
  Joints torques{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double above = q[i] - std::max(arm.limits().upper[i] - kLimitZone, home[i]);
    const double below = std::min(arm.limits().lower[i] + kLimitZone, home[i]) - q[i];
    const double inside = std::max(above, below);
    if (inside <= 0) continue;
    const double direction = above > below ? 1 : -1;
    // Critical, from a fifth of the zone on.
    const double damping = 2 * std::sqrt(kLimitStiffness * arm.mass(q)[i][i]) * std::min(1.0, 5 * inside / kLimitZone);
    torques[i] = -direction * (kLimitStiffness * inside + damping * std::max(0.0, direction * dq[i]));
  }
  return torques;
}

}  // namespace race::robot
