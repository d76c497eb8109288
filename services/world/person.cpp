#include "services/world/person.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/world/frames.h"

namespace race::world {
namespace {

// A light part is held no stiffer than this, critically damped: within what steps of 1 ms integrate well.
constexpr double kGripFrequency = 100;  // rad/s
constexpr double kTurnFrequency = 200;  // rad/s, of its orientation

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

bool finite(const Vec3& v) {
  return std::ranges::all_of(v, [](double each) { return std::isfinite(each); });
}

Expected<void> check_range(double value, double low, double high, const char* unit, const char* field) {
  if (value >= low && value <= high) return {};  // false for NaN
  const auto text = [](double number) {
    std::string digits = std::to_string(number);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
    return digits;
  };
  return unexpected(ErrorCode::out_of_range, "must be a number from " + text(low) + " to " + text(high) + ' ' + unit,
                    field);
}

/// The smallest moment of inertia that a body of this shape can have about an axis through its centre, roughly.
double least_inertia(const Shape& shape, double mass) {
  double radius = shape.size[0];
  if (shape.kind == Shape::Kind::box) radius = *std::ranges::min_element(shape.size) / 2;
  return 0.4 * mass * radius * radius;
}

const Body* part_of(const World& world, const std::string& name) {
  const auto& bodies = world.scene().bodies;
  const auto found = std::ranges::find(bodies, name, &Body::name);
  return found == bodies.end() ? nullptr : &*found;
}

}  // namespace

Expected<void> Person::check_body(const std::string& body, const Vec3& point) const {
  if (!world_.has(body)) return unexpected(ErrorCode::not_found, "there is no link or part `" + body + "`", "body");
  if (!world_.present(body)) return unexpected(ErrorCode::conflict, "`" + body + "` was taken away", "body");
  if (!world_.movable(body)) return unexpected(ErrorCode::type, "`" + body + "` cannot be moved", "body");
  return check_range(finite(point) ? length(point) : NAN, 0, Hold::kFarthest, "m from the body's origin", "point");
}

Expected<void> Person::grab(const std::string& name, const Hold& hold) {
  if (auto ok = check_body(hold.body, hold.point); !ok) return ok;
  if (auto ok = check_range(hold.stiffness, Hold::kSoftest, Hold::kStiffest, "N/m", "stiffness"); !ok) return ok;
  if (auto ok = check_range(hold.damping, 0, Hold::kMostDamping, "Ns/m", "damping"); !ok) return ok;
  if (auto ok = check_range(hold.force, 0, Hold::kStrongest, "N", "limit"); !ok) return ok;
  if (!hands_.contains(name) && hands_.size() >= kHands)
    return unexpected(ErrorCode::conflict, "there are " + std::to_string(kHands) + " hands already", "hand");
  Hand hand{.hold = hold, .stiffness = hold.stiffness, .damping = hold.damping};
  if (const Body* part = part_of(world_, hold.body)) {
    hand.stiffness = std::min(hand.stiffness, part->mass * kGripFrequency * kGripFrequency);
    hand.damping = std::min(hand.damping, 2 * part->mass * kGripFrequency);
  }
  hand.held = hand.last = world_.pose(hold.body);
  hand.timeout = std::numeric_limits<double>::infinity();
  hand.idle_since = world_.time();
  const Vec3 at = transform(hand.held, hold.point);
  hand.touch = {hold.body, at, {}, at};
  hands_.insert_or_assign(name, std::move(hand));
  return {};
}

Expected<Person::Hand*> Person::find(const std::string& name) {
  const auto found = hands_.find(name);
  if (found == hands_.end()) return unexpected(ErrorCode::conflict, "the hand holds nothing", "hand");
  return &found->second;
}

Expected<void> Person::drag(const std::string& name, const Drag& drag) {
  ASSIGN_OR_RETURN(Hand * hand, find(name));
  if (auto ok = check_range(drag.speed, 1e-3, Drag::kFastest, "m/s", "speed"); !ok) return ok;
  if (drag.path.empty() || drag.path.size() > Drag::kPoints)
    return unexpected(ErrorCode::out_of_range, "must have 1 to " + std::to_string(Drag::kPoints) + " points", "path");
  for (const Vec3& point : drag.path)
    if (auto ok = check_range(finite(point) ? length(point) : NAN, 0, 10, "m from o", "path"); !ok) return ok;
  hand->path.assign(drag.path.rbegin(), drag.path.rend());
  hand->speed = drag.speed;
  hand->idle_since = world_.time();
  return {};
}

Expected<void> Person::keep(const std::string& name, double timeout) {
  ASSIGN_OR_RETURN(Hand * hand, find(name));
  if (!(timeout >= 0)) return unexpected(ErrorCode::out_of_range, "must not be negative", "keep");
  hand->timeout = timeout;
  hand->idle_since = world_.time();
  return {};
}

void Person::release(const std::string& hand) { hands_.erase(hand); }

Expected<void> Person::push(const Push& push) {
  if (auto ok = check_body(push.body, push.point); !ok) return ok;
  if (auto ok = check_range(finite(push.force) ? length(push.force) : NAN, 0, Hold::kStrongest, "N", "force"); !ok)
    return ok;
  if (auto ok = check_range(push.duration, World::kStep, Push::kLongest, "s", "duration"); !ok) return ok;
  if (auto ok = check_range(push.rise, 0, push.duration / 2, "s, half of the duration", "rise"); !ok) return ok;
  if (pushes_.size() >= kPushes) return unexpected(ErrorCode::conflict, "too many pushes at once", "body");
  pushes_.push_back({push, world_.time(), {push.body, transform(world_.pose(push.body), push.point), {}, {}}});
  return {};
}

void Person::let_go_of(const std::string& part) {
  std::erase_if(hands_, [&](const auto& hand) { return hand.second.hold.body == part; });
  std::erase_if(pushes_, [&](const Pushing& each) { return each.push.body == part; });
}

Expected<void> Person::place(const std::string& part, const std::optional<Pose>& o_t_part) {
  if (!o_t_part && world_.has(part) && world_.present(part))
    return unexpected(ErrorCode::missing, "a part that is there needs a pose to go to", "pose");
  const Pose pose = o_t_part ? *o_t_part : world_.has(part) ? world_.pose(part) : Pose();
  auto placed = world_.place(part, pose);
  if (placed) let_go_of(part);
  return placed;
}

Expected<void> Person::take(const std::string& part) {
  auto taken = world_.take(part);
  if (taken) let_go_of(part);
  return taken;
}

void Person::step() {
  const double now = world_.time();
  std::erase_if(hands_, [&](const auto& hand) { return now - hand.second.idle_since > hand.second.timeout; });
  for (auto& [name, hand] : hands_) pull(hand);
  // Half a step: sums of steps are not exact.
  std::erase_if(pushes_, [&](const Pushing& p) { return now - p.begin > p.push.duration - World::kStep / 2; });
  for (Pushing& each : pushes_) {
    const Push& push = each.push;
    const double since = now - each.begin + World::kStep / 2;  // the middle of the coming step
    const double share = push.rise > 0 ? std::clamp(std::min(since, push.duration - since) / push.rise, 0.0, 1.0) : 1.0;
    each.touch.at = transform(world_.pose(push.body), push.point);
    each.touch.force = share * push.force;
    world_.push(push.body, each.touch.force, each.touch.at);
  }
}

void Person::pull(Hand& hand) {
  Vec3& target = *hand.touch.target;
  double way = hand.speed * World::kStep;
  while (!hand.path.empty() && way > 0) {
    const Vec3 rest = hand.path.back() - target;
    const double distance = length(rest);
    target = distance <= way ? hand.path.back() : target + (way / distance) * rest;
    if (distance <= way) hand.path.pop_back();
    way -= distance;
    hand.idle_since = world_.time();
  }
  const Pose now = world_.pose(hand.hold.body);
  const Vec3 at = transform(now, hand.hold.point);
  const Vec3 speed = (1 / World::kStep) * (at - transform(hand.last, hand.hold.point));
  Vec3 force = hand.stiffness * (target - at) - hand.damping * speed;
  if (const double size = length(force); size > hand.hold.force) force = (hand.hold.force / size) * force;
  world_.push(hand.hold.body, force, at);
  keep_orientation(hand, now);
  hand.last = now;
  hand.touch.at = at;
  hand.touch.force = force;
}

// Fingers around a part turn with the hand, which does not turn. A link is too large for that: its point is held alone.
void Person::keep_orientation(const Hand& hand, const Pose& now) {
  const Body* part = part_of(world_, hand.hold.body);
  if (!part) return;
  const double inertia = least_inertia(part->shape, part->mass);
  const Vec3 speed = (1 / World::kStep) * rotation_between(hand.last, now);
  world_.twist(hand.hold.body, (inertia * kTurnFrequency * kTurnFrequency) * rotation_between(now, hand.held) -
                                   (2 * inertia * kTurnFrequency) * speed);
}

std::vector<std::pair<std::string, Touch>> Person::touches() const {
  std::vector<std::pair<std::string, Touch>> all;
  for (const auto& [name, hand] : hands_) all.emplace_back(name, hand.touch);
  for (const Pushing& each : pushes_) all.emplace_back("push", each.touch);
  return all;
}

}  // namespace race::world
