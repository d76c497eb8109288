#include "services/robot/jogging.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace race::robot {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector7 = Eigen::Matrix<double, 7, 1>;
using Matrix67 = Eigen::Matrix<double, 6, 7, Eigen::RowMajor>;

constexpr double kNearSingular = 0.08;  // singular value of the Jacobian (m and rad) from which on it is damped
constexpr double kDamping = 0.04;       // at a singularity
constexpr double kNothing = 1e-6;       // rad/s; does not count as moving towards a limit
constexpr double kComfort = 0.8;        // share of the braking that joint limits are neared with

tl::unexpected<Refusal> out_of_range(const char* argument, std::string message) {
  return tl::unexpected<Refusal>(Refusal{"out_of_range", argument, std::move(message)});
}

double length(const Vec3& vector) { return std::hypot(vector[0], vector[1], vector[2]); }

bool finite(const auto& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double v) { return std::isfinite(v); });
}

tl::expected<void, Refusal> check_joints(const Joints& wanted, const JogLimits& limits) {
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!(std::abs(wanted[i]) <= limits.velocity[i]))
      return out_of_range("joints", "joint " + std::to_string(i + 1) + " is jogged with at most " +
                                        std::to_string(limits.velocity[i]) + " rad/s");
  }
  return {};
}

tl::expected<void, Refusal> check_tool(const ToolVelocity& wanted) {
  if (!finite(wanted.linear) || !(length(wanted.linear) <= JogLimits::kLinear))
    return out_of_range("linear", "the tool is jogged with at most 0.25 m/s");
  if (!finite(wanted.angular) || !(length(wanted.angular) <= JogLimits::kAngular))
    return out_of_range("angular", "the tool is turned with at most 1 rad/s");
  return {};
}

Vector6 along_o(const ToolVelocity& wanted, const Pose& o_t_tool) {
  const auto& q = o_t_tool.orientation;
  const Eigen::Quaterniond turn = wanted.axes == ToolVelocity::Axes::tool
                                      ? Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized()
                                      : Eigen::Quaterniond::Identity();
  Vector6 velocity;
  velocity.head<3>() = turn * Eigen::Map<const Eigen::Vector3d>(wanted.linear.data());
  velocity.tail<3>() = turn * Eigen::Map<const Eigen::Vector3d>(wanted.angular.data());
  return velocity;
}

/// The smallest joint speeds for a velocity of the tool, so none in the null space: the pseudoinverse of the Jacobian,
/// damped along the directions that are nearly singular (A. Maciejewski, C. Klein, "Numerical filtering for the
/// operation of robotic manipulators through kinematically singular configurations", J. Robotic Systems 5(6), 1988).
Joints joint_speeds(const Jacobian& rows, const Vector6& velocity) {
  const Eigen::Map<const Matrix67> jacobian(rows[0].data());
  const Eigen::SelfAdjointEigenSolver<Matrix6> directions(jacobian * jacobian.transpose());
  Vector6 along = directions.eigenvectors().transpose() * velocity;
  for (int i = 0; i < 6; ++i) {
    const double squared = std::max(0.0, directions.eigenvalues()(i));
    const double near = std::max(0.0, 1 - std::sqrt(squared) / kNearSingular);
    along(i) /= squared + kDamping * kDamping * near * near;
  }
  Joints speeds;
  Eigen::Map<Vector7>(speeds.data()) = jacobian.transpose() * (directions.eigenvectors() * along);
  return speeds;
}

void scale(Joints& speeds, double share) {
  for (double& speed : speeds) speed *= share;
}

/// So that none is above its limit, in the same direction.
void keep_below(const Joints& limits, Joints& speeds) {
  double share = 1;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (std::abs(speeds[i]) > limits[i]) share = std::min(share, limits[i] / std::abs(speeds[i]));
  }
  scale(speeds, share);
}

}  // namespace

JogLimits jog_limits(const ArmModel& arm, const Joints& acceleration, const Joints& braking) {
  JogLimits limits;
  limits.braking = braking;
  for (std::size_t i = 0; i < kJoints; ++i) {
    limits.velocity[i] = arm.limits().velocity[i] / 2;
    limits.acceleration[i] = acceleration[i] / 2;
  }
  return limits;
}

tl::expected<void, Refusal> check_jog(const JogVelocity& wanted, const JogLimits& limits) {
  if (const auto* joints = std::get_if<Joints>(&wanted)) return check_joints(*joints, limits);
  return check_tool(std::get<ToolVelocity>(wanted));
}

/// Of a joint that moves with `dq` at most as fast that it can stand at its limit, less the margin; rad/s, at least 0.
double Jogging::most_towards_limit(std::size_t joint, double dq, double braking, double dt) const {
  const JointLimits& limits = arm_.limits();
  const double q = reference_.q[joint];
  const double left = (dq > 0 ? limits.upper[joint] - q : q - limits.lower[joint]) - kMargin - std::abs(dq) * dt;
  return std::sqrt(2 * braking * std::max(0.0, left));
}

/// A joint slows down by itself if joints are wanted; the whole motion does if the tool is to keep its direction.
void Jogging::keep_joint_limits(Joints& wanted, double dt) const {
  double share = 1;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double most = most_towards_limit(i, wanted[i], kComfort * limits_.braking[i], dt);
    if (std::abs(wanted[i]) <= std::max(most, kNothing)) continue;
    share = std::min(share, most / std::abs(wanted[i]));
    if (std::holds_alternative<Joints>(wanted_)) wanted[i] = std::copysign(most, wanted[i]);
  }
  if (!std::holds_alternative<Joints>(wanted_)) scale(wanted, share);
}

Joints Jogging::wanted_joints(double share, std::optional<double> tool_speed, double dt) const {
  if (share <= 0) return {};
  Joints wanted;
  if (const auto* joints = std::get_if<Joints>(&wanted_)) {
    wanted = *joints;
  } else {
    const Vector6 velocity = along_o(std::get<ToolVelocity>(wanted_), arm_.forward(reference_.q));
    wanted = joint_speeds(arm_.jacobian(reference_.q), velocity);
    keep_below(limits_.velocity, wanted);
  }
  scale(wanted, share);
  keep_joint_limits(wanted, dt);
  const double fast = tool_way(arm_, reference_.q, wanted);
  if (tool_speed && fast > *tool_speed) scale(wanted, *tool_speed / fast);
  return wanted;
}

/// The joint speeds after a cycle: all go the same share of their way to the wanted ones, so that the tool keeps its
/// direction as it slows down.
Joints Jogging::on_the_way_to(const Joints& wanted, double dt) const {
  double share = 1;
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double change = wanted[i] - reference_.dq[i];
    const double speeding_up = limits_.acceleration[i] * dt;
    const bool slows = change * reference_.dq[i] < 0;  // and then, perhaps, speeds up the other way
    const double most =
        slows ? std::min(limits_.braking[i] * dt, std::abs(reference_.dq[i]) + speeding_up) : speeding_up;
    if (std::abs(change) > most) share = std::min(share, most / std::abs(change));
  }
  if (share == 1) return wanted;
  Joints speeds = reference_.dq;
  for (std::size_t i = 0; i < kJoints; ++i) {
    speeds[i] += share * (wanted[i] - speeds[i]);
    const double most = most_towards_limit(i, speeds[i], limits_.braking[i], dt);
    speeds[i] = std::clamp(speeds[i], -most, most);
  }
  return speeds;
}

Reference Jogging::advance(double share, std::optional<double> tool_speed, double dt) {
  const Joints speeds = on_the_way_to(wanted_joints(share, tool_speed, dt), dt);
  for (std::size_t i = 0; i < kJoints; ++i) reference_.ddq[i] = (speeds[i] - reference_.dq[i]) / dt;
  const Reference now = reference_;
  for (std::size_t i = 0; i < kJoints; ++i) reference_.q[i] += (now.dq[i] + speeds[i]) / 2 * dt;
  reference_.dq = speeds;
  return now;
}

}  // namespace race::robot
