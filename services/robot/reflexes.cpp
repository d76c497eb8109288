#include "services/robot/reflexes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "services/robot/observer.h"
#include "services/robot/trajectory.h"

namespace race::robot {
namespace {

constexpr double kForceRearm = 0.8;  // share of a force limit below which it is armed again
constexpr double kLead = 0.002;      // s of way besides braking: a cycle to see it and one to act
constexpr double kAtRest = 1e-3;     // rad/s

int order(Signal signal) {
  switch (signal) {
    case Signal::collision:
      return 0;
    case Signal::force_limit:
      return 1;
    case Signal::virtual_wall:
      return 2;
    case Signal::joint_limit:
      return 3;
    case Signal::contact:
      return 4;
  }
  return 5;
}

bool is_touch(Signal signal) { return signal == Signal::contact || signal == Signal::collision; }

}  // namespace

void Reflexes::set(const std::vector<Reflex>& reflexes) {
  watched_.clear();
  for (const Reflex& reflex : reflexes) watched_.push_back({reflex});
  std::stable_sort(watched_.begin(), watched_.end(),
                   [](const auto& a, const auto& b) { return order(a.reflex.signal) < order(b.reflex.signal); });
}

void Reflexes::go_on_with(const std::vector<Reflex>& reflexes) {
  const std::vector<Watched> before = std::exchange(watched_, {});
  set(reflexes);
  for (Watched& watched : watched_) {
    watched.on = std::any_of(before.begin(), before.end(),
                             [&](const Watched& earlier) { return earlier.on && earlier.reflex == watched.reflex; });
  }
}

std::vector<Incident> Reflexes::update(const Joints& q, const Joints& dq, const Joints& external_torques, double dt) {
  const Touch touch = detector_.update(external_torques, dt);
  std::vector<Incident> incidents;
  if (touch.collision) add_touch(*touch.collision, Signal::collision, incidents);
  for (Watched& watched : watched_) {
    if (is_touch(watched.reflex.signal)) {
      watched.on = watched.on && detector_.touching();
      continue;
    }
    Incident incident{watched.reflex.signal, watched.reflex, {}, 0};
    const bool seen = sees(watched, q, dq, external_torques, incident.joint);
    if (seen && !watched.on) incidents.push_back(incident);
    watched.on = seen;
  }
  if (touch.contact) add_touch(*touch.contact, Signal::contact, incidents);
  return incidents;
}

void Reflexes::add_touch(const Contact& contact, Signal signal, std::vector<Incident>& incidents) {
  Watched* answer = nullptr;  // the one for the highest severity that was reached
  for (Watched& watched : watched_) {
    if (watched.reflex.signal != signal || watched.reflex.severity > contact.severity) continue;
    if (!answer || watched.reflex.severity > answer->reflex.severity) answer = &watched;
  }
  Incident incident{signal, std::nullopt, contact, 0};
  if (answer) {
    answer->on = true;
    incident.reflex = answer->reflex;
  }
  incidents.push_back(incident);
}

bool Reflexes::sees(const Watched& watched, const Joints& q, const Joints& dq, const Joints& torques,
                    std::size_t& joint) const {
  const Reflex& reflex = watched.reflex;
  if (reflex.signal == Signal::virtual_wall) return nears_wall(reflex.wall, q, dq);
  if (reflex.signal == Signal::joint_limit) return nears_limit(reflex.margin, q, dq, joint);
  const Vec3 force = wrench_at_tool(arm_, q, torques).force;
  return std::hypot(force[0], force[1], force[2]) > (watched.on ? kForceRearm : 1) * reflex.force;
}

bool Reflexes::nears_wall(const Wall& wall, const Joints& q, const Joints& dq) const {
  const double way = Braking(q, dq, braking_).duration() / 2 + kLead;
  const Jacobian jacobian = arm_.jacobian(q);
  const Vec3 now = arm_.forward(q).position;
  Vec3 soon = now;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kJoints; ++i) soon[axis] += way * jacobian[axis][i] * dq[i];
  }
  // One that stands behind the wall may come out again.
  return depth(wall, soon) > 0 && depth(wall, soon) > depth(wall, now) + 1e-6;
}

bool Reflexes::nears_limit(double margin, const Joints& q, const Joints& dq, std::size_t& joint) const {
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double soon = q[i] + dq[i] * (std::abs(dq[i]) / (2 * braking_[i]) + kLead);
    const bool above = dq[i] > kAtRest && soon > arm_.limits().upper[i] - margin;
    const bool below = dq[i] < -kAtRest && soon < arm_.limits().lower[i] + margin;
    if (!above && !below) continue;
    joint = i;
    return true;
  }
  return false;
}

double Reflexes::slowest() const {
  double scale = 1;
  for (const Watched& watched : watched_) {
    if (watched.on && watched.reflex.reaction == Reaction::slow_down) scale = std::min(scale, watched.reflex.scale);
  }
  return scale;
}

}  // namespace race::robot
