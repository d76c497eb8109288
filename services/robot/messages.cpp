#include "services/robot/messages.h"

#include <cmath>
#include <span>

namespace race::robot {
namespace {

tl::unexpected<Refusal> refuse(const char* code, std::string message) {
  return tl::unexpected<Refusal>(Refusal{code, "target", std::move(message)});
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

}  // namespace

tl::expected<MoveCommand, Refusal> read_move(const Dict& arguments) {
  const auto target = read_target(*arguments.find("target"));
  if (!target) return tl::unexpected(target.error());
  MoveCommand command{.target = *target};
  const bool relative = std::holds_alternative<Offset>(*target);
  const Value* kind = arguments.find("kind");
  const bool linear = kind && kind->is_string() ? kind->as_string() == "lin" : relative;
  command.kind = linear ? MotionKind::linear : MotionKind::point_to_point;
  command.speed = arguments.find("speed")->to_double();
  command.acceleration = arguments.find("acceleration")->to_double();
  return command;
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

Value contact_value(const Contact& contact, const ControlUnit& unit) {
  const Wrench wrench = wrench_at_tool(unit.arm(), unit.state().q, contact.torques);
  return Dict{{"link", Value(unit.arm().links()[contact.joint])},
              {"f_ext_hat", list(wrench.force)},
              {"m_ext_hat", list(wrench.torque)},
              {"tau_ext_hat", list(contact.torques)}};
}

Value to_value(const Refusal& refusal) {
  Dict error{{"code", Value(refusal.code)}, {"message", Value(refusal.message)}};
  if (!refusal.argument.empty()) error.set("argument", Value(refusal.argument));
  return error;
}

}  // namespace race::robot
