// RobotModel: what a URDF file says about a robot, as values: links, joints, inertias, shapes that touch and shapes
// that are seen. The plant, the robot's control unit and the camera are built from it; none of them sees urdfdom.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "services/world/pose.h"

namespace race::world {

/// A primitive body, centred in its frame; cylinders stand along z.
struct Shape {
  enum class Kind { box, cylinder, sphere };
  Kind kind = Kind::box;
  Vec3 size{};  // metres; box: edges x, y, z; cylinder: radius, length; sphere: radius
  bool operator==(const Shape&) const = default;
};

struct Collision {
  Shape shape;
  Pose link_t_shape;
};

/// What is seen of a link.
struct Visual {
  Shape shape;
  Pose link_t_shape;
  std::string colour;  // "#rrggbb"
};

struct Joint {
  enum class Kind { fixed, revolute, prismatic };
  std::string name;
  Kind kind = Kind::fixed;
  Pose parent_t_joint;
  Vec3 axis{0, 0, 1.0};     // unit vector in the joint's frame
  double lower = 0;         // rad or m
  double upper = 0;         // rad or m
  double max_effort = 0;    // Nm or N
  double max_velocity = 0;  // rad/s or m/s
};

struct Link {
  std::string name;
  int parent = -1;  // index into RobotModel::links; -1: the root
  Joint joint;      // leads from the parent to this link; meaningless for the root
  double mass = 0;  // kg; 0: a mere frame
  Vec3 com{};       // centre of mass in the link's frame
  Vec3 inertia{};   // kg m2, principal, about the centre of mass, axes parallel to the link's frame
  std::vector<Collision> collisions;
  std::vector<Visual> visuals;
};

struct RobotModel {
  std::string name;
  std::vector<Link> links;  // parents stand before their children; links[0] is the root

  /// Index of the link `name`, -1 if there is none.
  int link(std::string_view name) const;
  /// The links that a joint of `kind` moves, in order.
  std::vector<int> moved_by(Joint::Kind kind) const;
};

/// Reads a URDF text. Errors: `syntax` (no URDF), `type` (a joint or shape that is not served, an inertia that is not
/// principal in the link's frame), `missing` (a moving joint without limits, a moved link without inertia),
/// `duplicate` (two joints lead to a link), `out_of_range` (a mass, inertia, size or limit that cannot be), `too_deep`,
/// `too_large` (more than urdf_limits.h says; the text may come from anywhere).
Expected<RobotModel> read_urdf(const std::string& text);

/// As read_urdf, from a file. Error `io` if it cannot be read.
Expected<RobotModel> load_urdf(const std::string& path);

}  // namespace race::world
