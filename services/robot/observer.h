// External torques and forces from the generalised momentum.
// After A. De Luca, R. Mattone, "Actuator failure detection and isolation using generalized momenta", ICRA 2003, and
// S. Haddadin, A. De Luca, A. Albu-Schäffer, "Robot collisions: a survey on detection, isolation, and identification",
// IEEE T-RO 33(6), 2017.
#pragma once

#include <optional>

#include "services/robot/arm_model.h"

namespace race::robot {

/// Estimates the joint torques that come from outside: those that explain how the momentum p = M(q) dq changes and the
/// drives, gravity and Coriolis forces do not. The estimate follows with a first-order lag of 1 / gain.
class MomentumObserver {
 public:
  MomentumObserver(const ArmModel& arm, double gain_per_s) : arm_(arm), gain_(gain_per_s) {}

  /// Takes the state at the end of a step of `dt` seconds in which the drives gave `torques`. The first call starts it.
  void update(const Joints& q, const Joints& dq, const Joints& torques, double dt);

  /// tau_ext, Nm.
  const Joints& torques() const { return residual_; }

 private:
  struct Past {
    Joints q, dq;
    MassMatrix mass;
  };
  const ArmModel& arm_;
  double gain_;
  std::optional<Past> past_;
  Joints explained_{};  // integral of what the model and the residual explain, plus the first momentum
  Joints residual_{};
};

/// A force and a torque at the tool centre point, in o.
struct Wrench {
  Vec3 force{};   // N
  Vec3 torque{};  // Nm
};

/// The wrench at the tool that explains `torques` best, least squares, damped near singular postures.
Wrench wrench_at_tool(const ArmModel& arm, const Joints& q, const Joints& torques);

}  // namespace race::robot
