// Reflexes: compares what the robot senses with the reflexes of its behavior, every millisecond. It says what happened
// and which reflex answers; the control unit reacts.
#pragma once

#include <optional>
#include <vector>

#include "services/robot/arm_model.h"
#include "services/robot/behavior.h"
#include "services/robot/contact.h"

namespace race::robot {

/// Something that began in this cycle, and the reflex that answers it; contacts and collisions are told without one,
/// too.
struct Incident {
  Signal signal = Signal::contact;
  std::optional<Reflex> reflex;
  Contact contact;        // contact, collision
  std::size_t joint = 0;  // joint_limit
};

class Reflexes {
 public:
  /// `arm` outlives it; `contact_thresholds` [Nm]; `braking` [rad/s2]: walls and joint limits are seen early enough to
  /// stop before them.
  Reflexes(const ArmModel& arm, const Joints& contact_thresholds, const Joints& braking)
      : arm_(arm), braking_(braking), detector_(contact_thresholds) {}

  /// The reflexes of another behavior act from now on.
  void set(const std::vector<Reflex>& reflexes);
  /// As set(), but a reflex that there was before does not answer again a signal that lasts.
  void go_on_with(const std::vector<Reflex>& reflexes);

  /// Incidents of one cycle of `dt` seconds in the order in which their reflexes come: collision, force_limit,
  /// virtual_wall, joint_limit, contact.
  std::vector<Incident> update(const Joints& q, const Joints& dq, const Joints& external_torques, double dt);

  /// The share of the speed that reflexes with `slow_down` leave while their signals last; 1: none does.
  double slowest() const;

 private:
  struct Watched {
    Reflex reflex;
    bool on = false;  // its signal lasts
  };
  /// Whether the signal of a wall, a force or a joint limit is there; `joint` gets the joint of a limit.
  bool sees(const Watched& watched, const Joints& q, const Joints& dq, const Joints& torques, std::size_t& joint) const;
  bool nears_wall(const Wall& wall, const Joints& q, const Joints& dq) const;
  bool nears_limit(double margin, const Joints& q, const Joints& dq, std::size_t& joint) const;
  void add_touch(const Contact& contact, Signal signal, std::vector<Incident>& incidents);

  const ArmModel& arm_;
  Joints braking_;
  ContactDetector detector_;
  std::vector<Watched> watched_;  // in the order of their signals
};

}  // namespace race::robot
