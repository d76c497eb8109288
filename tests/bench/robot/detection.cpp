#include <cmath>
#include <stdexcept>

#include "tests/bench/robot/cell.h"
#include "tests/bench/robot/collision.h"

namespace race::robot {
namespace {

bool above_threshold(const Joints& residual) {
  static const Joints thresholds = lwr_settings().contact_thresholds;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (std::abs(residual[i]) > thresholds[i]) return true;
  }
  return false;
}

}  // namespace

Detection detect(double speed) {
  Behavior behavior = usual_behavior(Mode::position);
  behavior.operational.speed = speed;
  Cell cell(true), without(true);  // in step, and the same until the reflex acts
  cell.approach(behavior);
  behavior.reflexes.clear();
  without.approach(behavior);

  std::optional<double> contact, passed, changed;  // s
  std::optional<Severity> at_once;
  Severity worst{};
  for (int i = 0; i < 20000 && !(changed && cell.world->time() >= *changed + 0.2); ++i) {
    cell.step();
    if (!changed) without.step();
    const double now = cell.world->time();
    if (!contact && cell.force_on_column() > 0) contact = now;
    if (!passed && above_threshold(cell.unit->state().tau_ext)) passed = now;
    if (!changed && cell.world->torques() != without.world->torques()) changed = now;
    for (const Incident& incident : cell.unit->take_incidents()) {
      if (incident.signal != Signal::collision) continue;
      worst = incident.contact.severity;
      if (!at_once) at_once = worst;
    }
  }
  if (!contact || !passed || !changed || !at_once) throw std::runtime_error("the robot did not notice the column");
  return {(*passed - *contact) * 1000, (*changed - *passed) * 1000, *at_once, worst};
}

}  // namespace race::robot
