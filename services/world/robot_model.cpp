// URDF through urdfdom, checked and flattened into a RobotModel.
#include "services/world/robot_model.h"

#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "services/world/urdf_limits.h"
#include "services/world/urdf_tree.h"

namespace race::world {
namespace {

Vec3 vec3(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Pose pose(const urdf::Pose& p) { return {vec3(p.position), {p.rotation.x, p.rotation.y, p.rotation.z, p.rotation.w}}; }

bool positive(double v) { return std::isfinite(v) && v > 0; }

Expected<Shape> read_shape(const urdf::Geometry& geometry, const std::string& path) {
  Shape shape;
  if (const auto* box = dynamic_cast<const urdf::Box*>(&geometry)) {
    shape = {Shape::Kind::box, vec3(box->dim)};
  } else if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(&geometry)) {
    shape = {Shape::Kind::cylinder, {cylinder->radius, cylinder->length, 0}};
  } else if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(&geometry)) {
    shape = {Shape::Kind::sphere, {sphere->radius, 0, 0}};
  } else {
    return unexpected(ErrorCode::type, "shape must be box, cylinder or sphere", path);
  }
  const int lengths = shape.kind == Shape::Kind::box ? 3 : shape.kind == Shape::Kind::cylinder ? 2 : 1;
  for (int i = 0; i < lengths; ++i) {
    if (!positive(shape.size[static_cast<std::size_t>(i)]))
      return unexpected(ErrorCode::out_of_range, "shape: lengths must be greater than 0", path);
  }
  return shape;
}

/// As in scene files; a visual without a material is grey.
std::string colour(const urdf::Visual& visual) {
  if (!visual.material) return "#808080";
  const urdf::Color& c = visual.material->color;
  const auto byte = [](float share) { return static_cast<unsigned>(std::lround(std::clamp(share, 0.0F, 1.0F) * 255)); };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(c.r) & 0xFFU, byte(c.g) & 0xFFU, byte(c.b) & 0xFFU);
  return text;
}

Expected<Joint> read_joint(const urdf::Joint& source, const std::string& path) {
  Joint joint;
  joint.name = source.name;
  joint.parent_t_joint = pose(source.parent_to_joint_origin_transform);
  if (source.type == urdf::Joint::FIXED) return joint;
  if (source.type == urdf::Joint::REVOLUTE) {
    joint.kind = Joint::Kind::revolute;
  } else if (source.type == urdf::Joint::PRISMATIC) {
    joint.kind = Joint::Kind::prismatic;
  } else {
    return unexpected(ErrorCode::type, "joint must be fixed, revolute or prismatic", path);
  }
  joint.axis = vec3(source.axis);
  const double length = std::hypot(joint.axis[0], joint.axis[1], joint.axis[2]);
  if (!positive(length)) return unexpected(ErrorCode::out_of_range, "joint axis must not be zero", path);
  for (double& component : joint.axis) component /= length;
  if (!source.limits) return unexpected(ErrorCode::missing, "joint needs <limit>", path);
  joint.lower = source.limits->lower;
  joint.upper = source.limits->upper;
  joint.max_effort = source.limits->effort;
  joint.max_velocity = source.limits->velocity;
  if (!(joint.lower < joint.upper) || !positive(joint.max_effort) || !positive(joint.max_velocity))
    return unexpected(ErrorCode::out_of_range, "joint limits need lower < upper, effort > 0, velocity > 0", path);
  return joint;
}

Expected<void> read_inertia(const urdf::Link& source, Link& link, const std::string& path) {
  if (!source.inertial) {
    if (link.joint.kind != Joint::Kind::fixed)
      return unexpected(ErrorCode::missing, "a moved link needs <inertial>", path);
    return {};
  }
  const urdf::Inertial& inertial = *source.inertial;
  const urdf::Rotation& r = inertial.origin.rotation;
  if (inertial.ixy != 0 || inertial.ixz != 0 || inertial.iyz != 0 || std::abs(r.w) < 1.0 - 1e-12)
    return unexpected(ErrorCode::type, "inertia must be principal in the link's frame (no rpy, no products)", path);
  link.mass = inertial.mass;
  link.com = vec3(inertial.origin.position);
  link.inertia = {inertial.ixx, inertial.iyy, inertial.izz};
  if (!positive(link.mass) || !positive(inertial.ixx) || !positive(inertial.iyy) || !positive(inertial.izz))
    return unexpected(ErrorCode::out_of_range, "mass and inertia must be greater than 0", path);
  return {};
}

Expected<void> add_link(const urdf::Link& source, int parent, std::size_t depth, RobotModel& model) {
  const std::string path = model.name + "/" + source.name;
  if (depth > kUrdfChain)
    return unexpected(ErrorCode::too_deep, "a chain has at most " + std::to_string(kUrdfChain) + " links", path);
  Link link;
  link.name = source.name;
  link.parent = parent;
  if (source.parent_joint) {
    ASSIGN_OR_RETURN(link.joint, read_joint(*source.parent_joint, path + "/" + source.parent_joint->name));
  }
  if (auto read = read_inertia(source, link, path); !read) return read;
  for (const auto& collision : source.collision_array) {
    ASSIGN_OR_RETURN(const Shape shape, read_shape(*collision->geometry, path + "/collision"));
    link.collisions.push_back({shape, pose(collision->origin)});
  }
  for (const auto& visual : source.visual_array) {
    ASSIGN_OR_RETURN(const Shape shape, read_shape(*visual->geometry, path + "/visual"));
    link.visuals.push_back({shape, pose(visual->origin), colour(*visual)});
  }
  const int index = static_cast<int>(model.links.size());
  model.links.push_back(std::move(link));
  for (const auto& child : source.child_links) {
    if (auto added = add_link(*child, index, depth + 1, model); !added) return added;
  }
  return {};
}

}  // namespace

int RobotModel::link(std::string_view name) const {
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

std::vector<int> RobotModel::moved_by(Joint::Kind kind) const {
  std::vector<int> moved;
  for (std::size_t i = 1; i < links.size(); ++i) {
    if (links[i].joint.kind == kind) moved.push_back(static_cast<int>(i));
  }
  return moved;
}

Expected<RobotModel> read_urdf(const std::string& text) {
  if (auto good = check_urdf_text(text); !good) return tl::unexpected(std::move(good).error());
  if (auto tree = check_urdf_tree(text); !tree) return tl::unexpected(std::move(tree).error());
  const urdf::ModelInterfaceSharedPtr source = urdf::parseURDF(text);
  if (!source || !source->getRoot()) return unexpected(ErrorCode::syntax, "not a URDF document");
  RobotModel model;
  model.name = source->getName();
  if (auto added = add_link(*source->getRoot(), -1, 1, model); !added) return tl::unexpected(added.error());
  return model;
}

Expected<RobotModel> load_urdf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) return unexpected(ErrorCode::io, "cannot read the file", path);
  auto model = read_urdf(text.str());
  if (!model && model.error().path.empty()) model.error().path = path;
  return model;
}

}  // namespace race::world
