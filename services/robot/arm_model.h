// ArmModel: kinematics and rigid-body dynamics of the seven-joint arm up to its tool centre point (KDL inside).
//
// Threads: one at a time; its const functions share scratch memory.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "services/world/pose.h"
#include "services/world/robot_model.h"

namespace race::robot {

using world::Pose;
using world::Vec3;

inline constexpr std::size_t kJoints = 7;
using Joints = std::array<double, kJoints>;
/// Rows: v_x, v_y, v_z, w_x, w_y, w_z of the tool centre point in o; columns: joints.
using Jacobian = std::array<Joints, 6>;
using MassMatrix = std::array<Joints, kJoints>;

struct JointLimits {
  Joints lower{}, upper{};  // rad
  Joints velocity{};        // rad/s
  Joints effort{};          // Nm
};

class ArmModel {
 public:
  /// The chain from the model's root, which stands at `o_t_base`, to its link `tip`. What hangs beside the chain (the
  /// jaws) counts as fixed at the middle of its stroke. Errors: `not_found` (no link `tip`), `type` (not seven moving,
  /// revolute joints in between).
  static Expected<ArmModel> create(const world::RobotModel& model, const Pose& o_t_base, std::string_view tip = "tcp");
  ~ArmModel();
  ArmModel(ArmModel&&) noexcept;
  ArmModel& operator=(ArmModel&&) noexcept;

  const JointLimits& limits() const { return limits_; }
  /// Names of the seven links that the joints move, from the base outwards.
  const std::array<std::string, kJoints>& links() const { return links_; }
  /// Length of the stretched chain from the second joint to the tool centre point, m: nothing beyond it is reachable.
  double reach() const { return reach_; }
  /// Where the second joint is, in o.
  const Vec3& shoulder() const { return shoulder_; }

  /// Pose of the tool centre point in o.
  Pose forward(const Joints& q) const;
  Jacobian jacobian(const Joints& q) const;
  /// Joint torques [Nm] for the motion q, dq, ddq, gravity included.
  Joints inverse_dynamics(const Joints& q, const Joints& dq, const Joints& ddq) const;
  Joints gravity(const Joints& q) const;
  /// C(q, dq) dq.
  Joints coriolis(const Joints& q, const Joints& dq) const;
  MassMatrix mass(const Joints& q) const;

 private:
  struct Chain;
  ArmModel();

  std::unique_ptr<Chain> chain_;  // KDL's objects, known to arm_model.cpp alone
  JointLimits limits_;
  std::array<std::string, kJoints> links_;
  double reach_ = 0;
  Vec3 shoulder_{};
};

}  // namespace race::robot
