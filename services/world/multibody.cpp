// From RobotModel to btMultiBody: fixed base, revolute, prismatic and fixed joints, colliders, mechanical end stops.
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <cmath>

#include "services/world/multibody_internal.h"
#include "services/world/world.h"

namespace race::world {
namespace {

btVector3 to_bullet(const Vec3& v) { return {v[0], v[1], v[2]}; }

// A brake is friction that sticks in a place, not only at a speed of zero: as the contact solver ends before a chain of
// brakes is solved, a stretched arm would creep 5 mm/s.
constexpr double kSticks = 0.02;  // rad/s and slower
constexpr double kSlips = 0.002;  // rad off its place, it has been overcome
constexpr double kReturn = 0.1;   // of the way back to its place, in a step

bool is_frame(const Link& link) { return link.mass == 0 && link.joint.kind == Joint::Kind::fixed; }

/// The link's frame seen from its centre of mass.
btTransform com_t_link(const Link& link) { return btTransform(btQuaternion::getIdentity(), -to_bullet(link.com)); }

}  // namespace

btTransform to_bullet(const Pose& pose) {
  const auto& q = pose.orientation;
  return btTransform(btQuaternion(q[0], q[1], q[2], q[3]), to_bullet(pose.position));
}

Pose from_bullet(const btTransform& transform) {
  const btVector3& p = transform.getOrigin();
  const btQuaternion q = transform.getRotation();
  return {{p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

std::unique_ptr<btCollisionShape> make_shape(const Shape& shape) {
  const Vec3& size = shape.size;
  switch (shape.kind) {
    case Shape::Kind::box:
      return std::make_unique<btBoxShape>(to_bullet(size) / 2);
    case Shape::Kind::cylinder:
      return std::make_unique<btCylinderShapeZ>(btVector3(size[0], size[0], size[1] / 2));
    case Shape::Kind::sphere:
      return std::make_unique<btSphereShape>(size[0]);
  }
  return nullptr;
}

Robot::Robot(const RobotModel& model, const Mounting& mounting, btMultiBodyDynamicsWorld& world)
    : model_(model), world_(world), bullet_index_(model.links.size(), -1) {
  const Link& root = model.links.front();
  int count = 0;
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    if (!is_frame(model.links[i])) bullet_index_[i] = count++;
  }
  body_ = std::make_unique<btMultiBody>(count, root.mass, to_bullet(root.inertia), true, false);
  body_->setBaseWorldTransform(to_bullet(mounting.o_t_base) * com_t_link(root).inverse());
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    if (is_frame(link)) continue;
    const Link& parent = model.links[static_cast<std::size_t>(link.parent)];
    const int index = bullet_index_[i];
    const int parent_index = bullet_index(link.parent);
    const btTransform parent_t_joint = to_bullet(link.joint.parent_t_joint);
    const btQuaternion parent_to_this = parent_t_joint.getRotation().inverse();
    const btVector3 pivot = parent_t_joint.getOrigin() - to_bullet(parent.com);
    const btVector3 inertia = to_bullet(link.inertia);
    switch (link.joint.kind) {
      case Joint::Kind::fixed:
        body_->setupFixed(index, link.mass, inertia, parent_index, parent_to_this, pivot, to_bullet(link.com));
        break;
      case Joint::Kind::revolute:
        body_->setupRevolute(index, link.mass, inertia, parent_index, parent_to_this, to_bullet(link.joint.axis), pivot,
                             to_bullet(link.com), true);
        break;
      case Joint::Kind::prismatic:
        body_->setupPrismatic(index, link.mass, inertia, parent_index, parent_to_this, to_bullet(link.joint.axis),
                              pivot, to_bullet(link.com), true);
        break;
    }
  }
  body_->finalizeMultiDof();
  body_->setHasSelfCollision(false);
  body_->setCanSleep(false);
  body_->setLinearDamping(0);
  body_->setAngularDamping(0);
  body_->setMaxCoordinateVelocity(1e3);
  world_.addMultiBody(body_.get());
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    if (!link.collisions.empty()) {
      const bool finger = link.joint.kind == Joint::Kind::prismatic;
      add_collider(link, bullet_index_[i], finger ? mounting.finger_friction : mounting.surface_friction);
    }
    if (i > 0 && link.joint.kind != Joint::Kind::fixed) {
      end_stops_.push_back(std::make_unique<btMultiBodyJointLimitConstraint>(body_.get(), bullet_index_[i],
                                                                             link.joint.lower, link.joint.upper));
      world_.addMultiBodyConstraint(end_stops_.back().get());
    }
    if (link.joint.kind == Joint::Kind::revolute) {
      auto motor = std::make_unique<btMultiBodyJointMotor>(body_.get(), bullet_index_[i], 0,
                                                           link.joint.max_effort * World::kStep);
      brakes_.push_back({bullet_index_[i], std::move(motor), {}});
    }
  }
}

Robot::~Robot() {
  set_brakes(false);
  for (auto& stop : end_stops_) world_.removeMultiBodyConstraint(stop.get());
  for (auto& collider : colliders_) world_.removeCollisionObject(collider.get());
  world_.removeMultiBody(body_.get());
}

void Robot::add_collider(const Link& link, int index, double friction) {
  auto compound = std::make_unique<btCompoundShape>();
  for (const Collision& collision : link.collisions) {
    shapes_.push_back(make_shape(collision.shape));
    compound->addChildShape(com_t_link(link) * to_bullet(collision.link_t_shape), shapes_.back().get());
  }
  auto collider = std::make_unique<btMultiBodyLinkCollider>(body_.get(), index);
  collider->setCollisionShape(compound.get());
  collider->setFriction(friction);
  // Coulomb friction that sticks in a place, not only at a speed of zero; without it a held part creeps 0.1 mm/s.
  collider->setCollisionFlags(collider->getCollisionFlags() | btCollisionObject::CF_HAS_FRICTION_ANCHOR);
  world_.addCollisionObject(collider.get(), btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  if (index < 0) {
    collider->setCollisionFlags(collider->getCollisionFlags() | btCollisionObject::CF_STATIC_OBJECT);
    body_->setBaseCollider(collider.get());
  } else {
    body_->getLink(index).m_collider = collider.get();
  }
  shapes_.push_back(std::move(compound));
  colliders_.push_back(std::move(collider));
}

void Robot::set_brakes(bool closed) {
  for (Brake& brake : brakes_) {
    btMultiBodyJointMotor& motor = *brake.motor;
    if (closed && !braked_) world_.addMultiBodyConstraint(&motor);
    if (!closed && braked_) world_.removeMultiBodyConstraint(&motor);
    const double q = body_->getJointPos(brake.index);
    if (!closed || (brake.sticks_at && std::abs(q - *brake.sticks_at) > kSlips)) brake.sticks_at.reset();
    if (closed && !brake.sticks_at && std::abs(body_->getJointVel(brake.index)) < kSticks) brake.sticks_at = q;
    motor.setPositionTarget(brake.sticks_at.value_or(q), brake.sticks_at ? kReturn : 0);
  }
  braked_ = closed;
}

void Robot::update_frames() {
  btAlignedObjectArray<btQuaternion> rotations;
  btAlignedObjectArray<btVector3> origins;
  body_->forwardKinematics(rotations, origins);
  body_->updateCollisionObjectWorldTransforms(rotations, origins);
}

Pose Robot::link_pose(int index) const {
  const Link& link = model_.links[static_cast<std::size_t>(index)];
  if (index == 0) return from_bullet(body_->getBaseWorldTransform() * com_t_link(link));
  if (is_frame(link)) return from_bullet(to_bullet(link_pose(link.parent)) * to_bullet(link.joint.parent_t_joint));
  return from_bullet(body_->getLink(bullet_index(index)).m_cachedWorldTransform * com_t_link(link));
}

}  // namespace race::world
