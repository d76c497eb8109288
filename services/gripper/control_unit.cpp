#include "services/gripper/control_unit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace race::gripper {
namespace {

constexpr double kSpeedGain = 60.0;      // Ns/m of the width's speed
constexpr double kDriveFriction = 10.0;  // Ns/m of the width's speed, what the spindle takes
constexpr double kPositionGain = 30.0;   // 1/s
constexpr double kPositionForce = 40.0;  // N, the most that moving to a width takes
constexpr double kTolerance = 0.002;     // m that the fingers may pass the width of a grasp
constexpr double kThinnest = 0.001;      // m; closer than that the fingers meet each other, not a part
constexpr double kArrived = 0.0005;      // m
constexpr double kStanding = 0.002;      // m/s
constexpr double kLost = 0.005;          // m that the fingers close further when a part is lost
constexpr int kStall = 60;               // ms without motion that count as an obstacle
constexpr int kClamping = 150;           // ms until the force is on and the part lies still

}  // namespace

ControlUnit::ControlUnit(double width) : width_(width) { rest_at(width); }

void ControlUnit::grasp(double width, double speed, double force) {
  assert(width >= 0 && width <= kStroke && speed >= kLeastSpeed && speed <= kMostSpeed);
  assert(force >= kLeastForce && force <= kMostForce);
  phase_ = Phase::close;
  target_ = width;
  pace_ = speed;
  force_ = force;
  elapsed_ = 0;
  outcome_.reset();
}

void ControlUnit::release(double width, double speed) {
  assert(width >= 0 && width <= kStroke && speed >= kLeastSpeed && speed <= kMostSpeed);
  phase_ = Phase::open;
  target_ = width;
  pace_ = speed;
  elapsed_ = 0;
  outcome_.reset();
}

void ControlUnit::stop() {
  outcome_.reset();
  if (phase_ != Phase::hold && phase_ != Phase::clamp) rest_at(width_);
}

void ControlUnit::rest_at(double width) {
  phase_ = Phase::rest;
  target_ = width;
}

double ControlUnit::control(double width, double speed) {
  width_ = width;
  speed_ = speed;
  switch (phase_) {
    case Phase::rest:
      return towards(target_, kMostSpeed);
    case Phase::close:
      return close();
    case Phase::clamp:
      return clamp();
    case Phase::hold:
      return hold();
    case Phase::open:
      return open();
  }
  return 0;
}

/// Closing force that moves the fingers to `width`, no faster than `largest_speed`.
double ControlUnit::towards(double width, double largest_speed) const {
  const double speed = std::clamp(kPositionGain * (width - width_), -largest_speed, largest_speed);
  const double opening_force = kSpeedGain * (speed - speed_) + kDriveFriction * speed;
  return std::clamp(-opening_force, -kPositionForce, kPositionForce);
}

bool ControlUnit::stalled() {
  elapsed_ = std::abs(speed_) < kStanding ? elapsed_ + 1 : 0;
  return elapsed_ > kStall;
}

double ControlUnit::close() {
  if (width_ < std::max(target_ - kTolerance, kThinnest)) {
    rest_at(width_);
    outcome_ = Outcome::no_part;
    return towards(target_, kMostSpeed);
  }
  if (stalled()) {
    phase_ = Phase::clamp;
    elapsed_ = 0;
  }
  const double closing_force = kSpeedGain * (pace_ + speed_) + kDriveFriction * pace_;
  return std::clamp(closing_force, -force_, force_);
}

double ControlUnit::clamp() {
  if (++elapsed_ == kClamping) {
    phase_ = Phase::hold;
    held_width_ = width_;
    outcome_ = Outcome::held;
  }
  const double ramp = std::min(1.0, 2.0 * elapsed_ / kClamping);
  return kLeastForce / 2 + ramp * (force_ - kLeastForce / 2);
}

double ControlUnit::hold() {
  if (width_ < held_width_ - kLost) {
    lost_ = true;
    rest_at(width_);
    return towards(width_, kMostSpeed);
  }
  return std::max(force_ + kSpeedGain * std::min(speed_, 0.0), 0.0);
}

double ControlUnit::open() {
  const bool arrived = std::abs(width_ - target_) < kArrived && std::abs(speed_) < kStanding;
  if (arrived || stalled()) {
    outcome_ = arrived ? Outcome::opened : Outcome::blocked;
    rest_at(arrived ? target_ : width_);
  }
  return towards(target_, pace_);
}

std::optional<Outcome> ControlUnit::take_outcome() { return std::exchange(outcome_, std::nullopt); }

bool ControlUnit::take_loss() { return std::exchange(lost_, false); }

}  // namespace race::gripper
