#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/bench/robot/cell.h"
#include "tests/bench/robot/collision.h"

namespace race::robot {
namespace {

/// A body of `mass` on a spring against a wall, one-dimensional along y: what a device is that measures such forces.
struct Clamp {
  double stiffness;         // N/m
  double mass;              // kg
  double damping;           // Ns/m
  double y = 0, speed = 0;  // of the body's face, beyond Cell::kFace

  /// Force [N] on the robot's side at `side`, and the body's motion during 1 ms, in small steps.
  double press(double side) {
    constexpr double kSkin = 2e5;  // N/m of the contact itself
    constexpr double kSkinDamping = 200;
    constexpr int kParts = 50;
    double mean = 0;
    for (int part = 0; part < kParts; ++part) {
      const double depth = side - Cell::kFace - y;
      const double force = depth > 0 ? std::max(0.0, kSkin * depth - kSkinDamping * speed) : 0;
      speed += (force - stiffness * y - damping * speed) / mass * (0.001 / kParts);
      y += speed * (0.001 / kParts);
      mean += force / kParts;
    }
    return mean;
  }
  double force() const { return stiffness * y; }
};

Clamping row(Mode mode, std::optional<Reaction> reaction) {
  Behavior behavior = usual_behavior(mode);
  behavior.reflexes.clear();
  if (reaction) behavior.reflexes.push_back({.signal = Signal::collision, .reaction = *reaction});
  return {std::string(name(mode)), reaction, std::move(behavior)};
}

}  // namespace

std::string Clamping::reaction_name() const { return reaction ? std::string(name(*reaction)) : "no reflex"; }

std::vector<Clamping> clampings() {
  std::vector<Clamping> rows;
  for (const Mode mode : {Mode::position, Mode::joint_impedance, Mode::cartesian_impedance}) {
    rows.push_back(row(mode, {}));
    for (const Reaction reaction :
         {Reaction::stop, Reaction::gravity_compensation, Reaction::retreat, Reaction::slow_down})
      rows.push_back(row(mode, reaction));
  }
  Clamping gentle = row(Mode::cartesian_impedance, {});
  gentle.mode += ", `force` 20";
  gentle.behavior.operational.force = 20;
  rows.push_back(gentle);
  for (const auto& reaction : {std::optional<Reaction>(), std::optional(Reaction::stop)}) {
    rows.push_back(row(Mode::gravity_compensation, reaction));
    rows.back().mode += ", let go";
  }
  return rows;
}

ClampForce clamp(Behavior behavior, double speed) {
  Cell cell(false);
  Clamp body{75e3, 0.6, 40.0};
  const bool led = behavior.operational.mode == Mode::gravity_compensation;
  behavior.operational.speed = speed;
  if (led) {
    cell.unit->set_behavior(behavior);
  } else {
    cell.approach(behavior);
  }
  ClampForce found{0, 0};
  double before = cell.side();
  bool met = false;
  int after = 0;  // ms since they met
  for (int i = 0; i < 30000 && after < 2000; ++i) {
    const double force = body.press(cell.side());
    met = met || force > 0;
    after += met ? 1 : 0;
    const double moves = (cell.side() - before) / 0.001;
    before = cell.side();
    const auto p = cell.world->pose("tcp").position;
    if (led && !met) cell.world->push("gripper", {0, 200 * (speed - moves), 0}, p);
    if (force > 0) cell.world->push("gripper", {0, -force, 0}, {p[0], p[1] + Cell::kHalfGripper, p[2]});
    cell.step();
    found.peak = std::max(found.peak, body.force());
    found.after = std::abs(body.force());
  }
  if (after < 2000) throw std::runtime_error("the robot did not meet the clamped body");
  return found;
}

}  // namespace race::robot
