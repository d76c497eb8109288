// The compliant control laws: torques that make the arm a spring and damper at its joints or at its tool. Inertia is
// not shaped; damping is designed from the mass matrix by double diagonalisation (A. Albu-Schäffer, C. Ott, U. Frese,
// G. Hirzinger, "Cartesian impedance control of redundant robots", ICRA 2003). Pure functions.
#pragma once

#include "services/robot/arm_model.h"
#include "services/robot/behavior.h"
#include "services/robot/trajectory.h"

namespace race::robot {

/// tau = K (q_d - q) + D (dq_d - dq) + M ddq_d + C dq + g.
Joints joint_impedance(const ArmModel& arm, const Operational& behavior, const Joints& q, const Joints& dq,
                       const Reference& reference);

/// tau = J^T (K e + D (v_d - v)) + N tau_0 + M ddq_d + C dq + g; e: way and rotation vector of the tool to where the
/// reference has it, the spring's pull limited to `behavior.force`. Redundancy: tau_0, a soft spring to the reference's
/// posture, acts in the null space of the tool alone (dynamically consistent: N = I - J^T Lambda J M^-1).
Joints cartesian_impedance(const ArmModel& arm, const Operational& behavior, const Joints& q, const Joints& dq,
                           const Reference& reference);

/// Torques that keep the arm from its joint limits where nothing else does: a spring and damper over the last
/// kLimitZone rad before each, or from `home` on where that is nearer to the limit.
Joints limit_cushions(const ArmModel& arm, const Joints& q, const Joints& dq, const Joints& home);
inline constexpr double kLimitZone = 0.1;

}  // namespace race::robot
