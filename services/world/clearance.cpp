// Forward kinematics of the model, then boxes around the shapes, then GJK for those that are near.
#include "services/world/clearance.h"

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <LinearMath/btTransform.h>

#include <vector>

#include "services/world/multibody_internal.h"

namespace race::world {
namespace {

/// A convex shape that sits on a link of the robot, or (link -1) stands in the scene.
struct Solid {
  std::unique_ptr<btCollisionShape> shape;
  int link = -1;
  btTransform link_t_solid, o_t_solid;
  btVector3 low{0, 0, 0}, high{0, 0, 0};  // the box around it, along o

  Solid(std::unique_ptr<btCollisionShape> made, int on, const btTransform& place)
      : shape(std::move(made)), link(on), link_t_solid(place), o_t_solid(place) {}

  const btConvexShape& convex() const { return static_cast<const btConvexShape&>(*shape); }
  void bound() { shape->getAabb(o_t_solid, low, high); }
};

/// Exact shapes: Bullet rounds off the edges of a box by its margin; a sphere is all margin.
std::unique_ptr<btCollisionShape> sharp(const Shape& shape) {
  auto made = make_shape(shape);
  if (shape.kind != Shape::Kind::sphere) made->setMargin(0);
  return made;
}

bool boxes_apart(const Solid& a, const Solid& b, double margin) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.low[axis] > b.high[axis] + margin || b.low[axis] > a.high[axis] + margin) return true;
  }
  return false;
}

bool apart(const Solid& a, const Solid& b, double margin) {
  if (boxes_apart(a, b, margin)) return true;
  btGjkEpaSolver2::sResults results;
  const btVector3 guess = b.o_t_solid.getOrigin() - a.o_t_solid.getOrigin();
  if (!btGjkEpaSolver2::Distance(&a.convex(), a.o_t_solid, &b.convex(), b.o_t_solid, guess, results)) return false;
  const auto rounding = [](const Solid& solid) {
    return solid.shape->getShapeType() == SPHERE_SHAPE_PROXYTYPE ? solid.shape->getMargin() : 0.0;
  };
  return results.distance - rounding(a) - rounding(b) >= margin;
}

}  // namespace

struct Clearance::Geometry {
  const RobotModel model;
  btTransform o_t_base;
  std::vector<int> revolute;  // -1, or the arm joint that moves this link
  std::vector<btTransform> o_t_link;
  std::vector<Solid> fixed, moving;
  std::vector<std::pair<std::size_t, std::size_t>> self;  // of `moving`, pairs that could meet

  Geometry(const RobotModel& source, const Scene& scene);
  int joints_up_to(int link) const;
  void place(const std::array<double, 7>& q);
};

Clearance::Geometry::Geometry(const RobotModel& source, const Scene& scene)
    : model(source), o_t_base(to_bullet(scene.robot.o_t_base)), o_t_link(source.links.size()) {
  int arm_joint = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    revolute.push_back(i > 0 && model.links[i].joint.kind == Joint::Kind::revolute ? arm_joint++ : -1);
    for (const Collision& collision : model.links[i].collisions) {
      moving.emplace_back(sharp(collision.shape), static_cast<int>(i), to_bullet(collision.link_t_shape));
    }
  }
  for (const Body& body : scene.bodies) {
    if (body.mass > 0) continue;
    fixed.emplace_back(sharp(body.shape), -1, to_bullet(body.o_t_body));
    fixed.back().bound();
  }
  for (std::size_t a = 0; a < moving.size(); ++a) {
    for (std::size_t b = a + 1; b < moving.size(); ++b) {
      if (std::abs(joints_up_to(moving[a].link) - joints_up_to(moving[b].link)) >= 3) self.emplace_back(a, b);
    }
  }
}

int Clearance::Geometry::joints_up_to(int link) const {
  int count = 0;
  for (; link > 0; link = model.links[static_cast<std::size_t>(link)].parent)
    count += revolute[static_cast<std::size_t>(link)] >= 0 ? 1 : 0;
  return count;
}

void Clearance::Geometry::place(const std::array<double, 7>& q) {
  o_t_link[0] = o_t_base;
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    const btVector3 axis(link.joint.axis[0], link.joint.axis[1], link.joint.axis[2]);
    btTransform motion = btTransform::getIdentity();
    if (revolute[i] >= 0) motion.setRotation(btQuaternion(axis, q[static_cast<std::size_t>(revolute[i])]));
    if (link.joint.kind == Joint::Kind::prismatic) motion.setOrigin(axis * link.joint.upper);
    o_t_link[i] = o_t_link[static_cast<std::size_t>(link.parent)] * to_bullet(link.joint.parent_t_joint) * motion;
  }
  for (Solid& solid : moving) {
    solid.o_t_solid = o_t_link[static_cast<std::size_t>(solid.link)] * solid.link_t_solid;
    solid.bound();
  }
}

Clearance::Clearance(const RobotModel& model, const Scene& scene)
    : geometry_(std::make_unique<Geometry>(model, scene)) {}

Clearance::~Clearance() = default;

bool Clearance::keeps(const std::array<double, 7>& q, double margin) {
  geometry_->place(q);
  for (const Solid& solid : geometry_->moving) {
    if (solid.link == 0) continue;
    for (const Solid& body : geometry_->fixed) {
      if (!apart(solid, body, margin)) return false;
    }
  }
  for (const auto& [a, b] : geometry_->self) {
    if (!apart(geometry_->moving[a], geometry_->moving[b], margin)) return false;
  }
  return true;
}

}  // namespace race::world
