#include "server/cell/person_command.h"

#include <algorithm>
#include <cmath>

#include "services/world/frames.h"

namespace race::server {
namespace {

constexpr double kLongestKeep = 3600;   // s
constexpr std::size_t kBodyName = 200;  // characters

using Need = Fields::Need;
using world::operator+;

/// `N` numbers of a list; a violation if it is none.
template <std::size_t N>
std::optional<std::array<double, N>> numbers(const Value& value, const std::string& name, Fields& fields) {
  std::array<double, N> out;
  bool fits = value.is_list() && value.as_list().size() == N;
  for (std::size_t i = 0; fits && i < N; ++i) {
    const Value& item = value.as_list()[i];
    fits = item.is_numeric() && item.is_finite();
    if (fits) out[i] = item.to_double();
  }
  if (fits) return out;
  fields.violation(ErrorCode::type, "`" + name + "` must be " + std::to_string(N) + " numbers");
  return std::nullopt;
}

world::Vec3 vector(Fields& fields, std::string_view name, Need need = Need::optional) {
  const Value* value = fields.find(name, need);
  if (!value) return {};
  return numbers<3>(*value, std::string(name), fields).value_or(world::Vec3());
}

// Of UTF-8: bytes that begin one.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string hand_name(Fields& fields) {
  std::string hand = fields.text("hand").value_or("hand");
  if (hand.empty() || characters(hand) > kHandName)
    fields.violation(ErrorCode::name, "`hand` must have 1 to " + std::to_string(kHandName) + " characters");
  return hand;
}

// Of a link or part; what is refused later quotes it.
std::string body_name(Fields& fields, const char* field) {
  std::string body = fields.text(field, Need::required).value_or("");
  if (characters(body) <= kBodyName) return body;
  fields.violation(ErrorCode::out_of_range,
                   "`" + std::string(field) + "` has at most " + std::to_string(kBodyName) + " characters");
  return {};
}

GrabCommand read_grab(Fields& fields) {
  GrabCommand command{hand_name(fields), {}};
  world::Hold& hold = command.hold;
  hold.body = body_name(fields, "body");
  hold.point = vector(fields, "point");
  hold.stiffness = fields.number("stiffness").value_or(hold.stiffness);
  hold.damping = fields.number("damping").value_or(hold.damping);
  hold.force = fields.number("limit").value_or(hold.force);
  return command;
}

DragCommand read_drag(Fields& fields) {
  DragCommand command{hand_name(fields), {}};
  const Value* to = fields.find("to");
  const Value* by = fields.find("by");
  const Value* path = fields.find("path");
  if ((to != nullptr) + (by != nullptr) + (path != nullptr) != 1)
    fields.violation(ErrorCode::missing, "must have one of `to`, `by` and `path`");
  const auto add = [&](const Value& value, const char* name) {
    if (auto point = numbers<3>(value, name, fields)) command.drag.path.push_back(*point);
  };
  if (to) add(*to, "to");
  if (by) add(*by, "by");
  command.relative = by != nullptr;
  if (path && !path->is_list()) fields.violation(ErrorCode::type, "`path` must be a list of points");
  if (path && path->is_list())
    for (const Value& point : path->as_list()) add(point, "path");
  command.drag.speed = fields.number("speed").value_or(command.drag.speed);
  return command;
}

world::Push read_push(Fields& fields) {
  world::Push push;
  push.body = body_name(fields, "body");
  push.force = vector(fields, "force", Need::required);
  push.point = vector(fields, "point");
  if (!fields.find("duration")) fields.violation(ErrorCode::missing, "the field `duration` is missing");
  push.duration = fields.number("duration").value_or(0);
  push.rise = fields.number("rise").value_or(0);
  return push;
}

std::optional<world::Pose> read_pose(Fields& fields) {
  const Value* value = fields.find("pose");
  if (!value) return std::nullopt;
  const Value* position = value->is_dict() ? value->find("position") : nullptr;
  const Value* orientation = value->is_dict() ? value->find("orientation") : nullptr;
  world::Pose pose;
  if (!position || !orientation || value->as_dict().size() != 2) {
    fields.violation(ErrorCode::type, "`pose` must have `position` and `orientation`, nothing else");
    return pose;
  }
  pose.position = numbers<3>(*position, "pose.position", fields).value_or(pose.position);
  pose.orientation = numbers<4>(*orientation, "pose.orientation", fields).value_or(pose.orientation);
  double square = 0;
  for (const double component : pose.orientation) square += component * component;
  if (std::abs(square - 1) > 1e-3)
    fields.violation(ErrorCode::out_of_range, "`pose.orientation` must be a unit quaternion");
  for (double& component : pose.orientation) component /= std::sqrt(square);
  if (std::ranges::any_of(pose.position, [](double each) { return std::abs(each) > 10; }))
    fields.violation(ErrorCode::out_of_range, "`pose.position` must be within 10 m of o");
  return pose;
}

struct Performer {
  world::Person& person;
  double keep;

  Expected<void> operator()(const GrabCommand& command) const {
    auto done = person.grab(command.hand, command.hold);
    return done ? person.keep(command.hand, keep) : done;
  }
  Expected<void> operator()(const DragCommand& command) const {
    world::Drag drag = command.drag;
    if (command.relative)
      for (const auto& [hand, touch] : person.touches())
        if (hand == command.hand && touch.target) drag.path.front() = drag.path.front() + *touch.target;
    auto done = person.drag(command.hand, drag);
    return done ? person.keep(command.hand, keep) : done;
  }
  Expected<void> operator()(const ReleaseCommand& command) const {
    person.release(command.hand);
    return {};
  }
  Expected<void> operator()(const world::Push& push) const { return person.push(push); }
  Expected<void> operator()(const PlaceCommand& command) const { return person.place(command.part, command.o_t_part); }
  Expected<void> operator()(const TakeCommand& command) const { return person.take(command.part); }
};

}  // namespace

PersonCommand read_person_command(Fields& fields, double keep) {
  const std::string kind = fields.text("act", Need::required).value_or("");
  PersonCommand command{ReleaseCommand{}, keep};
  if (kind == "grab" || kind == "drag") {
    if (kind == "grab") command.what = read_grab(fields);
    if (kind == "drag") command.what = read_drag(fields);
    command.keep = fields.number("keep").value_or(keep);
    if (command.keep != keep && !(command.keep >= 0 && command.keep <= kLongestKeep))
      fields.violation(ErrorCode::out_of_range, "`keep` must be a number from 0 to 3600 s");
  } else if (kind == "release") {
    command.what = ReleaseCommand{hand_name(fields)};
  } else if (kind == "push") {
    command.what = read_push(fields);
  } else if (kind == "place") {
    PlaceCommand place{body_name(fields, "part"), std::nullopt};
    place.o_t_part = read_pose(fields);
    command.what = std::move(place);
  } else if (kind == "take") {
    command.what = TakeCommand{body_name(fields, "part")};
  } else {
    fields.violation(ErrorCode::type, "`act` must be `grab`, `drag`, `release`, `push`, `place` or `take`");
  }
  return command;
}

Checked<PersonCommand> read_person_command(const Value& json, double keep) {
  std::vector<Error> errors;
  Fields fields(json, "", "the act", errors);
  PersonCommand command = read_person_command(fields, keep);
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return command;
}

Expected<void> perform(const PersonCommand& command, world::Person& person) {
  return std::visit(Performer{person, command.keep}, command.what);
}

}  // namespace race::server
