// From external torques to contacts and collisions: when one begins, how severe it is, whether it is intended.
// After S. Haddadin, A. De Luca, A. Albu-Schäffer, "Robot collisions: a survey on detection, isolation, and
// identification", IEEE T-RO 33(6), 2017: thresholds per joint on the momentum residual (III), the outermost joint that
// feels it (IV), accidental contacts rise fast and intended ones slowly (VI).
#pragma once

#include <optional>

#include "services/robot/arm_model.h"
#include "services/robot/behavior.h"

namespace race::robot {

struct Contact {
  std::size_t joint =
      0;             // the outermost joint with a torque above its threshold: the contact is on its link or farther out
  Joints torques{};  // Nm
  Severity severity = Severity::light;
  bool accidental = false;  // rose fast
};

/// What one cycle brought: each at most once per contact, a collision again when it gets more severe.
struct Touch {
  std::optional<Contact> contact;    // has begun
  std::optional<Contact> collision;  // an accidental contact, or an intended one that is more than light
};

class ContactDetector {
 public:
  /// An accidental contact goes from kFelt of its threshold to all of it within this, s.
  static constexpr double kFastOnset = 0.040;
  /// From these multiples of the thresholds on a contact is medium, severe. A push counts by its torque, an impact
  /// that is shorter than the observer's lag by the momentum that it exchanged: both are what the residual shows.
  static constexpr double kMedium = 3.0;
  static constexpr double kSevere = 6.0;

  explicit ContactDetector(const Joints& thresholds) : thresholds_(thresholds) {}
  /// Takes the external torques [Nm] of a cycle of `dt` seconds. A contact begins when one passes its joint's
  /// threshold; it has ended, and the detector is armed again, when all have fallen below kRearm of theirs.
  Touch update(const Joints& external_torques, double dt);
  bool touching() const { return touching_; }

 private:
  static constexpr double kFelt = 0.3;
  static constexpr double kRearm = 0.6;

  Joints thresholds_;
  double onset_ = 0;  // s since the torques were last below kFelt
  bool touching_ = false, accidental_ = false;
  std::optional<Severity> reported_;  // of the collision of this contact
};

}  // namespace race::robot
