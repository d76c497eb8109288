#include "services/robot/messages.h"

#include <cmath>
#include <span>

#include "services/robot/behavior_value.h"

namespace race::robot {
namespace {

constexpr double kSmallestPart = 0.001;  // m, an edge
constexpr double kLargestPart = 0.5;

tl::unexpected<Refusal> refuse(const char* code, std::string message, const char* argument = "target") {
  return tl::unexpected<Refusal>(Refusal{code, argument, std::move(message)});
}

tl::expected<void, Refusal> read_numbers(const Value* value, const std::string& name, std::span<double> out) {
  if (!value || !value->is_list() || value->as_list().size() != out.size())
    return refuse("type", name + " must be a list of " + std::to_string(out.size()) + " numbers");
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Value& item = value->as_list()[i];
    if (!item.is_numeric())
      return refuse("type", name + " must be a list of " + std::to_string(out.size()) + " numbers");
    out[i] = item.to_double();
    if (!std::isfinite(out[i])) return refuse("out_of_range", name + " must be finite");
  }
  return {};
}

tl::expected<Target, Refusal> read_target(const Value& value) {
  const std::size_t fields = value.is_dict() ? value.as_dict().size() : 0;
  if (const Value* joints = value.find("joints"); joints && fields == 1) {
    Joints q;
    if (auto read = read_numbers(joints, "joints", q); !read) return tl::unexpected(read.error());
    return q;
  }
  if (const Value* offset = value.find("offset"); offset && fields == 1) {
    Offset way;
    if (auto read = read_numbers(offset, "offset", way.metres); !read) return tl::unexpected(read.error());
    return way;
  }
  if (value.find("position") && value.find("orientation") && fields == 2) {
    Pose pose;
    if (auto read = read_numbers(value.find("position"), "position", pose.position); !read)
      return tl::unexpected(read.error());
    if (auto read = read_numbers(value.find("orientation"), "orientation", pose.orientation); !read)
      return tl::unexpected(read.error());
    return pose;
  }
  return refuse("type", "target must be a pose {position, orientation}, {joints} or {offset}, with no other fields");
}

Value list(std::span<const double> numbers) {
  List items;
  for (const double number : numbers) items.emplace_back(number);
  return items;
}

tl::expected<Vec3, Refusal> read_carried(const Value& value, MotionKind kind) {
  if (kind != MotionKind::free) return refuse("type", "`carried` is only for motions of kind free", "carried");
  Vec3 edges;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edges[i] = value.find("box")->as_list()[i].to_double();
    if (!(edges[i] >= kSmallestPart && edges[i] <= kLargestPart))
      return refuse("out_of_range", "`carried.box` must be edges of 0.001 to 0.5 m", "carried");
  }
  return edges;
}

/// An optional argument; nullptr: it is not given, or null.
const Value* given(const Dict& arguments, const char* name) {
  const Value* value = arguments.find(name);
  return value && !value->is_null() ? value : nullptr;
}

/// Requires a list of numbers, as many as `Numbers` has.
template <typename Numbers>
Numbers numbers(const Value& value) {
  Numbers out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = value.as_list()[i].to_double();
  return out;
}

}  // namespace

tl::expected<Action, Refusal> read_move(const Dict& arguments) {
  const auto target = read_target(*arguments.find("target"));
  if (!target) return tl::unexpected(target.error());
  Action action{{.target = *target}, std::nullopt, std::nullopt};
  MoveCommand& command = action.command;
  const Value* kind = arguments.find("kind");
  if (kind && kind->is_string()) {
    command.kind = kind->as_string() == "lin"    ? MotionKind::linear
                   : kind->as_string() == "free" ? MotionKind::free
                                                 : MotionKind::point_to_point;
  } else if (std::holds_alternative<Offset>(*target)) {
    command.kind = MotionKind::linear;
  }
  command.speed = arguments.find("speed")->to_double();
  command.acceleration = arguments.find("acceleration")->to_double();
  if (const Value* value = arguments.find("behavior"); value && !value->is_null()) {
    auto behavior = read_behavior(*value);
    if (!behavior) return tl::unexpected(behavior.error());
    action.behavior = std::move(*behavior);
  }
  if (const Value* value = arguments.find("carried"); value && !value->is_null()) {
    const auto edges = read_carried(*value, command.kind);
    if (!edges) return tl::unexpected(edges.error());
    action.carried = *edges;
  }
  return action;
}

tl::expected<JogVelocity, Refusal> read_jog(const Dict& arguments) {
  const Value* joints = given(arguments, "joints");
  const Value* linear = given(arguments, "linear");
  const Value* angular = given(arguments, "angular");
  if ((joints != nullptr) == (linear || angular))
    return refuse("type", "either `joints`, or `linear`, `angular` or both of them are wanted", "joints");
  if (joints) return numbers<Joints>(*joints);
  ToolVelocity velocity;
  if (linear) velocity.linear = numbers<Vec3>(*linear);
  if (angular) velocity.angular = numbers<Vec3>(*angular);
  if (arguments.find("frame")->as_string() == "tool") velocity.axes = ToolVelocity::Axes::tool;
  return velocity;
}

Value to_value(const Pose& pose) {
  return Dict{{"position", list(pose.position)}, {"orientation", list(pose.orientation)}};
}

Value to_value(const Joints& joints) { return list(joints); }

Value to_value(const RobotState& state) {
  return Dict{{"q", list(state.q)},
              {"dq", list(state.dq)},
              {"tau", list(state.tau)},
              {"pose", to_value(state.pose)},
              {"f_ext_hat", list(state.external.force)},
              {"m_ext_hat", list(state.external.torque)},
              {"tau_ext_hat", list(state.tau_ext)}};
}

Value to_value(const Incident& incident, const ControlUnit& unit) {
  const RobotState state = unit.state();
  Dict data{{"reaction", Value(incident.reflex ? name(incident.reflex->reaction) : "none")}};
  const bool touch = incident.signal == Signal::contact || incident.signal == Signal::collision;
  if (touch) {
    const Contact& contact = incident.contact;
    data.set("link", Value(unit.arm().links()[contact.joint]));
    data.set("severity", Value(name(contact.severity)));
    data.set("classification", Value(contact.accidental ? "accidental" : "intended"));
  }
  if (touch || incident.signal == Signal::force_limit) {
    data.set("f_ext_hat", list(state.external.force));
    data.set("m_ext_hat", list(state.external.torque));
    data.set("tau_ext_hat", list(state.tau_ext));
  } else if (incident.signal == Signal::virtual_wall) {
    data.set("pose", to_value(state.pose));
  } else {
    data.set("joint", Value(static_cast<int>(incident.joint) + 1));
    data.set("q", list(state.q));
  }
  return data;
}

Value control_value(const ControlUnit& unit, const Value& collision) {
  const Operational& operational = unit.behavior().operational;
  Dict header{
      {"mode", Value(name(operational.mode))}, {"moving", unit.moving()}, {"speed_override", unit.speed_override()}};
  if (operational.mode == Mode::cartesian_impedance && operational.force) header.set("force", *operational.force);
  if (!collision.is_null()) header.set("collision", collision);
  return header;
}

Value to_value(const Refusal& refusal) {
  Dict error{{"code", Value(refusal.code)}, {"message", Value(refusal.message)}};
  if (!refusal.argument.empty()) error.set("argument", Value(refusal.argument));
  if (!refusal.reaction.empty()) error.set("reaction", Value(refusal.reaction));
  return error;
}

}  // namespace race::robot
