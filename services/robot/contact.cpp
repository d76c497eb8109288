#include "services/robot/contact.h"

#include <algorithm>
#include <cmath>

namespace race::robot {
namespace {

constexpr double kFeels = 0.25;  // share of its threshold from which on a joint counts as feeling the contact

Severity severity_of(double share) {
  if (share >= ContactDetector::kSevere) return Severity::severe;
  return share >= ContactDetector::kMedium ? Severity::medium : Severity::light;
}

}  // namespace

Touch ContactDetector::update(const Joints& external_torques, double dt) {
  double worst = 0;
  Contact contact{0, external_torques};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double share = std::abs(external_torques[i]) / thresholds_[i];
    worst = std::max(worst, share);
    if (share > kFeels) contact.joint = i;
  }
  onset_ = worst < kFelt ? 0 : onset_ + dt;

  if (touching_ && worst < kRearm) {
    touching_ = false;
    reported_.reset();
  }
  Touch touch;
  const bool begins = !touching_ && worst > 1;
  if (begins) {
    touching_ = true;
    accidental_ = onset_ <= kFastOnset;
  }
  if (!touching_) return touch;
  contact.accidental = accidental_;
  contact.severity = severity_of(worst);
  if (begins) touch.contact = contact;
  const bool collides = accidental_ || contact.severity > Severity::light;
  if (collides && (!reported_ || contact.severity > *reported_)) {
    reported_ = contact.severity;
    touch.collision = contact;
  }
  return touch;
}

}  // namespace race::robot
