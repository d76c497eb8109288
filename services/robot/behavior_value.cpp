#include "services/robot/behavior_value.h"

#include <cmath>
#include <cstdio>
#include <string>

#include "core/rsm/type.h"
#include "core/value/json.h"

namespace race::robot {

const char* const kBehaviorType = R"json({"record": {
  "operational": {"record": {
    "mode": {"enum": ["position", "joint_impedance", "cartesian_impedance", "gravity_compensation"]},
    "stiffness": {"optional": {"list": "number"}}, "damping": {"optional": "number"},
    "limits": {"optional": {"record": {"speed": {"optional": "number"}, "force": {"optional": "number"}}}}}},
  "reflexes": {"optional": {"list": {"record": {
    "signal": {"enum": ["contact", "collision", "force_limit", "virtual_wall", "joint_limit"]},
    "reaction": {"enum": ["stop", "gravity_compensation", "retreat", "slow_down"]},
    "severity": {"optional": {"enum": ["light", "medium", "severe"]}},
    "force": {"optional": "number"}, "margin": {"optional": "number"},
    "wall": {"optional": {"record": {
      "point": {"optional": {"list": "number", "size": 3}}, "normal": {"optional": {"list": "number", "size": 3}},
      "min": {"optional": {"list": "number", "size": 3}}, "max": {"optional": {"list": "number", "size": 3}}}}},
    "distance": {"optional": "number"}, "scale": {"optional": "number"}}}}}}})json";

namespace {

struct Range {
  double least, most;
};

constexpr Range kJointStiffness{0, 1000};   // Nm/rad
constexpr Range kToolStiffness{0, 3000};    // N/m
constexpr Range kTurningStiffness{0, 200};  // Nm/rad
constexpr Range kDamping{0.3, 1};
constexpr Range kSpeed{0.001, 2};       // m/s
constexpr Range kForce{1, 500};         // N
constexpr Range kMargin{0, 0.5};        // rad
constexpr Range kDistance{0.001, 0.5};  // m
constexpr Range kScale{0.01, 1};
constexpr double kFarthest = 10.0;  // m, of a wall
constexpr std::size_t kMostReflexes = 32;

using Read = tl::expected<void, Refusal>;

tl::unexpected<Refusal> refuse(const char* code, std::string message) {
  return tl::unexpected<Refusal>(Refusal{code, "behavior", std::move(message)});
}

/// The value of a field; a null one is as an absent one.
const Value* given(const Value& record, std::string_view field) {
  const Value* value = record.find(field);
  return value && !value->is_null() ? value : nullptr;
}

Read read_number(const Value& value, const std::string& field, const Range& range, double& out) {
  out = value.to_double();
  if (out >= range.least && out <= range.most) return {};
  char limits[64];
  std::snprintf(limits, sizeof limits, "%g to %g", range.least, range.most);
  return refuse("out_of_range", "`" + field + "` must be " + limits);
}

Read read_optional(const Value& record, std::string_view field, const Range& range, double& out) {
  const Value* value = given(record, field);
  return value ? read_number(*value, std::string(field), range, out) : Read();
}

Read read_vector(const Value& value, const std::string& field, Vec3& out) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (auto read = read_number(value.as_list()[i], field, {-kFarthest, kFarthest}, out[i]); !read) return read;
  }
  return {};
}

/// Refuses a field that has no meaning here.
Read only_with(const Value& record, std::string_view field, bool fits, const std::string& what) {
  if (fits || !given(record, field)) return {};
  return refuse("type", "`" + std::string(field) + "` is only for " + what);
}

Read read_stiffness(const Value& list, Operational& out) {
  const bool joints = out.mode == Mode::joint_impedance;
  const std::size_t size = joints ? kJoints : 6;
  if (list.as_list().size() != size)
    return refuse("type", "`stiffness` must have " + std::to_string(size) + " numbers in this mode");
  for (std::size_t i = 0; i < size; ++i) {
    double& target = joints ? out.joint_stiffness[i] : out.tool_stiffness[i];
    const Range range = joints ? kJointStiffness : i < 3 ? kToolStiffness : kTurningStiffness;
    if (auto read = read_number(list.as_list()[i], "stiffness", range, target); !read) return read;
  }
  return {};
}

Read read_limits(const Value& limits, Operational& out) {
  if (const Value* speed = given(limits, "speed")) {
    if (auto read = read_number(*speed, "limits.speed", kSpeed, out.speed.emplace()); !read) return read;
  }
  if (auto fits = only_with(limits, "force", out.mode == Mode::cartesian_impedance, "cartesian_impedance"); !fits)
    return fits;
  const Value* force = given(limits, "force");
  return force ? read_number(*force, "limits.force", kForce, out.force.emplace()) : Read();
}

Read read_operational(const Value& value, Operational& out) {
  const bool springs = out.mode == Mode::joint_impedance || out.mode == Mode::cartesian_impedance;
  for (const char* field : {"stiffness", "damping"}) {
    if (auto fits = only_with(value, field, springs, "the impedances"); !fits) return fits;
  }
  if (const Value* stiffness = given(value, "stiffness")) {
    if (auto read = read_stiffness(*stiffness, out); !read) return read;
  }
  if (auto read = read_optional(value, "damping", kDamping, out.damping); !read) return read;
  const Value* limits = given(value, "limits");
  return limits ? read_limits(*limits, out) : Read();
}

Read read_plane(const Value& wall, Wall& out) {
  Plane plane;
  if (auto read = read_vector(*given(wall, "point"), "wall.point", plane.point); !read) return read;
  if (auto read = read_vector(*given(wall, "normal"), "wall.normal", plane.normal); !read) return read;
  const double size = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
  if (size < 1e-6) return refuse("out_of_range", "`wall.normal` must have a direction");
  for (double& part : plane.normal) part /= size;
  out = plane;
  return {};
}

Read read_box(const Value& wall, Wall& out) {
  Box box;
  if (auto read = read_vector(*given(wall, "min"), "wall.min", box.min); !read) return read;
  if (auto read = read_vector(*given(wall, "max"), "wall.max", box.max); !read) return read;
  for (std::size_t i = 0; i < 3; ++i) {
    if (box.min[i] >= box.max[i]) return refuse("out_of_range", "`wall.min` must be less than `wall.max`");
  }
  out = box;
  return {};
}

Read read_wall(const Value& wall, Wall& out) {
  const bool plane = given(wall, "point") && given(wall, "normal");
  const bool box = given(wall, "min") && given(wall, "max");
  if (wall.as_dict().size() == 2 && plane) return read_plane(wall, out);
  if (wall.as_dict().size() == 2 && box) return read_box(wall, out);
  return refuse("type", "`wall` must be a plane {point, normal} or a box {min, max}");
}

template <typename Enum>
Enum read_enum(const Value& value, int count) {
  for (int i = 0; i < count; ++i) {
    if (name(static_cast<Enum>(i)) == value.as_string()) return static_cast<Enum>(i);
  }
  return Enum{};  // not reached: the value is of the TYPE
}

tl::expected<Reflex, Refusal> read_reflex(const Value& value) {
  Reflex reflex;
  reflex.signal = read_enum<Signal>(*value.find("signal"), 5);
  reflex.reaction = read_enum<Reaction>(*value.find("reaction"), 4);
  for (const auto& [field, signal] : {std::pair{"severity", Signal::collision},
                                      {"force", Signal::force_limit},
                                      {"wall", Signal::virtual_wall},
                                      {"margin", Signal::joint_limit}}) {
    if (auto fits = only_with(value, field, reflex.signal == signal, std::string(name(signal))); !fits)
      return tl::unexpected(fits.error());
  }
  for (const auto& [field, reaction] : {std::pair{"distance", Reaction::retreat}, {"scale", Reaction::slow_down}}) {
    if (auto fits = only_with(value, field, reflex.reaction == reaction, std::string(name(reaction))); !fits)
      return tl::unexpected(fits.error());
  }
  for (const auto& [field, signal] : {std::pair{"force", Signal::force_limit}, {"wall", Signal::virtual_wall}}) {
    if (reflex.signal == signal && !given(value, field))
      return refuse("missing", "a reflex on " + std::string(name(signal)) + " needs `" + field + "`");
  }
  if (const Value* severity = given(value, "severity")) reflex.severity = read_enum<Severity>(*severity, 3);
  Read read = read_optional(value, "force", kForce, reflex.force);
  if (read) read = read_optional(value, "margin", kMargin, reflex.margin);
  if (read) read = read_optional(value, "distance", kDistance, reflex.distance);
  if (read) read = read_optional(value, "scale", kScale, reflex.scale);
  if (const Value* wall = given(value, "wall"); read && wall) read = read_wall(*wall, reflex.wall);
  if (!read) return tl::unexpected(read.error());
  return reflex;
}

Read read_reflexes(const Value& list, std::vector<Reflex>& out) {
  out.clear();
  if (list.as_list().size() > kMostReflexes)
    return refuse("out_of_range", "`reflexes` must be at most " + std::to_string(kMostReflexes));
  for (const Value& item : list.as_list()) {
    const auto reflex = read_reflex(item);
    if (!reflex) return tl::unexpected(reflex.error());
    for (const Reflex& other : out) {
      const bool same = other.signal == reflex->signal && other.severity == reflex->severity;
      if (same && reflex->signal != Signal::virtual_wall)
        return refuse("duplicate", "two reflexes on " + std::string(name(other.signal)));
    }
    out.push_back(*reflex);
  }
  return {};
}

}  // namespace

tl::expected<Behavior, Refusal> read_behavior(const Value& value) {
  static const Value type = parse_json(kBehaviorType).value();
  static const Value& modes = *type.find("record")->find("operational")->find("record")->find("mode");
  if (value.is_string()) {
    if (const auto why = rsm::mismatch(modes, value)) return refuse("type", "`behavior`: " + *why);
    return usual_behavior(read_enum<Mode>(value, 4));
  }
  if (const auto why = rsm::mismatch(type, value)) return refuse("type", "`behavior`: " + *why);
  const Value& operational = *value.find("operational");
  Behavior behavior = usual_behavior(read_enum<Mode>(*operational.find("mode"), 4));
  if (auto read = read_operational(operational, behavior.operational); !read) return tl::unexpected(read.error());
  if (const Value* reflexes = given(value, "reflexes")) {
    if (auto read = read_reflexes(*reflexes, behavior.reflexes); !read) return tl::unexpected(read.error());
  }
  return behavior;
}

}  // namespace race::robot
