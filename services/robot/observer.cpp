#include "services/robot/observer.h"

#include <Eigen/Dense>
#include <cmath>

namespace race::robot {
namespace {

constexpr double kDamping = 1e-3;  // of the least squares; biases by less than 1 % away from singular postures

Joints times(const MassMatrix& matrix, const Joints& vector) {
  Joints product{};
  for (std::size_t row = 0; row < kJoints; ++row) {
    for (std::size_t column = 0; column < kJoints; ++column) product[row] += matrix[row][column] * vector[column];
  }
  return product;
}

}  // namespace

void MomentumObserver::update(const Joints& q, const Joints& dq, const Joints& torques, double dt) {
  const MassMatrix mass = arm_.mass(q);
  const Joints momentum = times(mass, dq);
  if (!past_) {
    explained_ = momentum;
  } else {
    // d/dt p = tau + C^T dq - g + tau_ext, where C^T dq = (dM/dt) dq - C dq.
    const Joints gravity = arm_.gravity(past_->q);
    const Joints coriolis = arm_.coriolis(past_->q, past_->dq);
    const Joints before = times(past_->mass, dq);
    for (std::size_t i = 0; i < kJoints; ++i) {
      const double change_of_mass = momentum[i] - before[i];
      explained_[i] += dt * (torques[i] - coriolis[i] - gravity[i] + residual_[i]) + change_of_mass;
      residual_[i] = gain_ * (momentum[i] - explained_[i]);
    }
  }
  past_ = Past{q, dq, mass};
}

Wrench wrench_at_tool(const ArmModel& arm, const Joints& q, const Joints& torques) {
  const Jacobian rows = arm.jacobian(q);
  const Eigen::Map<const Eigen::Matrix<double, 6, 7, Eigen::RowMajor>> jacobian(rows[0].data());
  const Eigen::Map<const Eigen::Matrix<double, 7, 1>> tau(torques.data());
  const Eigen::Matrix<double, 6, 6> gram =
      jacobian * jacobian.transpose() + kDamping * kDamping * Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Matrix<double, 6, 1> wrench = gram.ldlt().solve(jacobian * tau);
  return {{wrench(0), wrench(1), wrench(2)}, {wrench(3), wrench(4), wrench(5)}};
}

}  // namespace race::robot
