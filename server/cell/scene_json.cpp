#include "server/cell/scene_json.h"

#include <filesystem>

namespace race::server {
namespace {

template <std::size_t N>
Value numbers(const std::array<double, N>& values, std::size_t count = N) {
  return List(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
}

Value to_value(const world::Pose& pose) {
  return Dict{{"position", numbers(pose.position)}, {"orientation", numbers(pose.orientation)}};
}

Value to_value(const world::Shape& shape) {
  switch (shape.kind) {
    case world::Shape::Kind::box:
      return Dict{{"box", numbers(shape.size)}};
    case world::Shape::Kind::cylinder:
      return Dict{{"cylinder", Dict{{"radius", shape.size[0]}, {"length", shape.size[1]}}}};
    case world::Shape::Kind::sphere:
      break;
  }
  return Dict{{"sphere", shape.size[0]}};
}

Value to_value(const world::Body& body) {
  Dict json{{"name", body.name},
            {"shape", to_value(body.shape)},
            {"pose", to_value(body.o_t_body)},
            {"fixed", body.mass == 0}};
  if (!body.colour.empty()) json.set("colour", body.colour);
  if (body.mass > 0) json.set("mass", body.mass);
  return json;
}

List touches_json(const world::Person& person) {
  List hands;
  for (const auto& [hand, touch] : person.touches()) {
    Dict json{{"hand", hand}, {"body", touch.body}, {"at", numbers(touch.at)}, {"force", numbers(touch.force)}};
    if (touch.target) json.set("target", numbers(*touch.target));
    hands.push_back(std::move(json));
  }
  return hands;
}

}  // namespace

Value scene_json(const world::World& world) {
  const world::Scene& scene = world.scene();
  List bodies;
  for (const world::Body& body : scene.bodies) bodies.push_back(to_value(body));
  Value robot = Dict{{"name", "robot"},
                     {"urdf", std::filesystem::path(scene.robot.urdf).filename().string()},
                     {"pose", to_value(scene.robot.o_t_base)}};
  Value json = Dict{{"robots", List{std::move(robot)}}, {"bodies", std::move(bodies)}};
  return std::move(json.freeze());
}

Value pose_json(const world::World& world, const world::Person& person, services::Time time) {
  using world::Joint;
  Dict joints, bodies;
  const auto name = [&](int link) { return world.model().links[static_cast<std::size_t>(link)].joint.name; };
  const auto q = world.q();
  std::size_t joint = 0;
  for (const int link : world.model().moved_by(Joint::Kind::revolute)) joints.set(name(link), q[joint++]);
  // The jaws are kept in step: each is half of the opening away from the middle.
  for (const int link : world.model().moved_by(Joint::Kind::prismatic))
    joints.set(name(link), world.gripper_width() / 2);
  for (const world::Body& body : world.scene().bodies)
    if (body.mass > 0 && world.present(body.name)) bodies.set(body.name, to_value(world.pose(body.name)));
  Dict json{{"time", time}, {"joints", std::move(joints)}, {"bodies", std::move(bodies)}};
  if (List hands = touches_json(person); !hands.empty()) json.set("hands", std::move(hands));
  return json;
}

Value person_json(const world::World& world, const world::Person& person) {
  List absent;
  for (const world::Body& body : world.scene().bodies)
    if (!world.present(body.name)) absent.push_back(body.name);
  return Dict{{"hands", touches_json(person)}, {"absent", std::move(absent)}};
}

}  // namespace race::server
