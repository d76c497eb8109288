#include "services/robot/behavior.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace race::robot {
namespace {

constexpr std::array<std::string_view, 4> kModes = {"position", "joint_impedance", "cartesian_impedance",
                                                    "gravity_compensation"};
constexpr std::array<std::string_view, 5> kSignals = {"contact", "collision", "force_limit", "virtual_wall",
                                                      "joint_limit"};
constexpr std::array<std::string_view, 3> kSeverities = {"light", "medium", "severe"};
constexpr std::array<std::string_view, 4> kReactions = {"stop", "gravity_compensation", "retreat", "slow_down"};

double depth(const Plane& plane, const Vec3& point) {
  double height = 0;
  for (std::size_t i = 0; i < 3; ++i) height += plane.normal[i] * (point[i] - plane.point[i]);
  return -height;
}

double depth(const Box& box, const Vec3& point) {
  double inside = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) inside = std::min({inside, point[i] - box.min[i], box.max[i] - point[i]});
  return inside;
}

}  // namespace

Behavior usual_behavior(Mode mode) {
  Behavior behavior;
  behavior.operational.mode = mode;
  if (mode != Mode::gravity_compensation) behavior.reflexes.push_back(Reflex{});
  return behavior;
}

Behavior held_by_position(const Behavior& behavior) {
  if (behavior.operational.mode == Mode::position) return behavior;
  Behavior held = usual_behavior(Mode::position);
  held.operational.speed = behavior.operational.speed;
  std::copy_if(behavior.reflexes.begin(), behavior.reflexes.end(), std::back_inserter(held.reflexes),
               [](const Reflex& reflex) { return reflex.signal != Signal::collision; });
  return held;
}

Behavior guided(const Behavior& behavior) {
  Behavior guided = usual_behavior(Mode::gravity_compensation);
  std::copy_if(behavior.reflexes.begin(), behavior.reflexes.end(), std::back_inserter(guided.reflexes),
               [](const Reflex& reflex) {
                 return reflex.signal == Signal::virtual_wall || reflex.signal == Signal::joint_limit;
               });
  return guided;
}

std::string_view name(Mode mode) { return kModes[static_cast<std::size_t>(mode)]; }
std::string_view name(Signal signal) { return kSignals[static_cast<std::size_t>(signal)]; }
std::string_view name(Severity severity) { return kSeverities[static_cast<std::size_t>(severity)]; }
std::string_view name(Reaction reaction) { return kReactions[static_cast<std::size_t>(reaction)]; }

double depth(const Wall& wall, const Vec3& point) {
  return std::visit([&](const auto& shape) { return depth(shape, point); }, wall);
}

}  // namespace race::robot
