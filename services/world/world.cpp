// The plant: owns Bullet's objects, applies torques, forces and the jaws' synchronisation, and steps.
#include "services/world/world.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <LinearMath/btAlignedAllocator.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <new>
#include <stdexcept>

#include "services/world/multibody_internal.h"

namespace race::world {
namespace {

// Bullet uses what malloc() gives without a look at it.
void* allocate(std::size_t bytes) {
  if (void* memory = std::malloc(bytes)) return memory;
  throw std::bad_alloc();
}
const bool kAllocates = (btAlignedAllocSetCustom(allocate, std::free), true);

constexpr double kGravity = 9.81;  // m/s2
// Iterations of the contact solver: 10 let a held part turn in the fingers, more than 30 change nothing but the cost.
constexpr int kSolverIterations = 30;
// The rack and pinion that keeps the jaws in step, and the friction of the spindle drive, per jaw.
constexpr double kRackStiffness = 2e4;  // N/m
constexpr double kRackDamping = 40.0;   // Ns/m
constexpr double kDriveDamping = 20.0;  // Ns/m
// A part that is slower than this for 2 s (Bullet's time for all bodies) rests until something touches it.
constexpr double kRestSpeed = 0.001;  // m/s
constexpr double kRestTurn = 0.01;    // rad/s

struct Part {
  std::string name;
  std::unique_ptr<btCollisionShape> shape;
  std::unique_ptr<btRigidBody> body;
  bool present = true;
};

/// Notes what a shape at a trial pose is inside of, deeper than kDeepest.
struct Intrusion final : btCollisionWorld::ContactResultCallback {
  explicit Intrusion(const btCollisionObject& its_self) : self(its_self) {}
  bool needsCollision(btBroadphaseProxy* proxy) const override { return proxy->m_clientObject != &self; }
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                           const btCollisionObjectWrapper* b, int, int) override {
    if (point.getDistance() < -World::kDeepest)
      other = a->getCollisionObject() == trial ? b->getCollisionObject() : a->getCollisionObject();
    return 0;
  }
  const btCollisionObject& self;             // where it is now does not count
  const btCollisionObject* trial = nullptr;  // the shape as it would be
  const btCollisionObject* other = nullptr;
};

}  // namespace

struct World::Plant {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::unique_ptr<Robot> robot;
  std::vector<Part> parts;
  std::vector<int> arm;   // Bullet's link indices of the seven arm joints
  std::vector<int> jaws;  // and of the two jaws

  Plant(const Scene& scene, const RobotModel& model);
  ~Plant();
  void add_part(const Body& body);
  Part* part(std::string_view name);
  /// Bullet's link that a link of the model is, or sits on; -1: the base, which nothing moves.
  int carrier(std::string_view link, const RobotModel& model);
  std::string name_of(const btCollisionObject* collider, const RobotModel& model);
  const btCollisionObject* collider(std::string_view name, const RobotModel& model);
  void drive_jaws(double closing_force);
  /// All parts move freely again: what they rested on may be gone. What touches one wakes it without that.
  void wake();
};

World::Plant::Plant(const Scene& scene, const RobotModel& model) {
  world.setGravity(btVector3(0, 0, -kGravity));
  world.getSolverInfo().m_numIterations = kSolverIterations;
  world.getSolverInfo().m_leastSquaresResidualThreshold = 0;
  world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  world.getDispatchInfo().m_deterministicOverlappingPairs = true;
  robot = std::make_unique<Robot>(model, scene.robot, world);
  for (const int link : model.moved_by(Joint::Kind::revolute)) arm.push_back(robot->bullet_index(link));
  for (const int link : model.moved_by(Joint::Kind::prismatic)) jaws.push_back(robot->bullet_index(link));
  for (std::size_t i = 0; i < arm.size(); ++i) robot->body().setJointPos(arm[i], scene.robot.q[i]);
  for (const int jaw : jaws) robot->body().setJointPos(jaw, scene.robot.width / 2);
  robot->update_frames();
  for (const Body& body : scene.bodies) add_part(body);
}

World::Plant::~Plant() {
  for (Part& part : parts)
    if (part.present) world.removeRigidBody(part.body.get());
  robot.reset();
}

void World::Plant::add_part(const Body& body) {
  Part part{body.name, make_shape(body.shape), nullptr};
  btVector3 inertia(0, 0, 0);
  if (body.mass > 0) part.shape->calculateLocalInertia(body.mass, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(body.mass, nullptr, part.shape.get(), inertia);
  info.m_startWorldTransform = to_bullet(body.o_t_body);
  info.m_friction = body.friction;
  part.body = std::make_unique<btRigidBody>(info);
  part.body->setSleepingThresholds(kRestSpeed, kRestTurn);
  world.addRigidBody(part.body.get());
  parts.push_back(std::move(part));
}

void World::Plant::wake() {
  for (Part& part : parts) part.body->activate();
}

Part* World::Plant::part(std::string_view name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

int World::Plant::carrier(std::string_view name, const RobotModel& model) {
  int link = model.link(name);
  while (link > 0 && robot->bullet_index(link) < 0) link = model.links[static_cast<std::size_t>(link)].parent;
  return link < 0 ? -1 : robot->bullet_index(link);
}

std::string World::Plant::name_of(const btCollisionObject* object, const RobotModel& model) {
  for (const Part& part : parts)
    if (part.body.get() == object) return part.name;
  for (const Link& link : model.links)
    if (!link.collisions.empty() && collider(link.name, model) == object) return link.name;
  return "the robot";
}

const btCollisionObject* World::Plant::collider(std::string_view name, const RobotModel& model) {
  if (const Part* found = part(name)) return found->body.get();
  const int link = model.link(name);
  assert(link >= 0);
  const int index = robot->bullet_index(link);
  return index < 0 ? robot->body().getBaseCollider() : robot->body().getLink(index).m_collider;
}

void World::Plant::drive_jaws(double closing_force) {
  btMultiBody& body = robot->body();
  const double ahead = body.getJointPos(jaws[0]) - body.getJointPos(jaws[1]);
  const double speed_ahead = body.getJointVel(jaws[0]) - body.getJointVel(jaws[1]);
  const double rack = kRackStiffness * ahead + kRackDamping * speed_ahead;
  body.addJointTorque(jaws[0], -closing_force - kDriveDamping * body.getJointVel(jaws[0]) - rack);
  body.addJointTorque(jaws[1], -closing_force - kDriveDamping * body.getJointVel(jaws[1]) + rack);
}

World::World(const Scene& scene, const RobotModel& model)
    : scene_(scene), model_(model), plant_(std::make_unique<Plant>(scene_, model_)) {}

World::~World() = default;

Expected<std::unique_ptr<World>> World::create(const Scene& scene, const RobotModel& model) {
  const auto arm = model.moved_by(Joint::Kind::revolute);
  const auto jaws = model.moved_by(Joint::Kind::prismatic);
  if (arm.size() != kArmJoints || jaws.size() != 2)
    return unexpected(ErrorCode::type, "the robot needs seven revolute and two prismatic joints", model.name);
  for (std::size_t i = 0; i < kArmJoints; ++i) {
    const Joint& joint = model.links[static_cast<std::size_t>(arm[i])].joint;
    if (scene.robot.q[i] < joint.lower || scene.robot.q[i] > joint.upper)
      return unexpected(ErrorCode::out_of_range, "start posture outside of the limits of " + joint.name, "robot.q");
  }
  for (const int jaw : jaws) {
    const Joint& joint = model.links[static_cast<std::size_t>(jaw)].joint;
    if (scene.robot.width / 2 < joint.lower || scene.robot.width / 2 > joint.upper)
      return unexpected(ErrorCode::out_of_range, "start width outside of the gripper's stroke", "robot.width");
  }
  for (const Body& body : scene.bodies) {
    if (model.link(body.name) >= 0)
      return unexpected(ErrorCode::duplicate, "the robot has a link '" + body.name + "'", "bodies");
  }
  return std::unique_ptr<World>(new World(scene, model));
}

Expected<std::unique_ptr<World>> World::load(const std::string& scene_path) {
  ASSIGN_OR_RETURN(const Scene scene, load_scene(scene_path));
  ASSIGN_OR_RETURN(const RobotModel model, load_urdf(scene.robot.urdf));
  return create(scene, model);
}

void World::step() {
  btMultiBody& body = plant_->robot->body();
  plant_->robot->set_brakes(torques_set_at_ && steps_ >= *torques_set_at_ + kTorqueTimeoutSteps);
  if (braked()) torques_ = {};
  for (std::size_t i = 0; i < kArmJoints; ++i) body.addJointTorque(plant_->arm[i], torques_[i]);
  plant_->drive_jaws(gripper_force_);
  plant_->world.stepSimulation(kStep, 0);  // 0 substeps: exactly one step of kStep
  body.clearForcesAndTorques();
  plant_->robot->update_frames();
  ++steps_;
}

void World::reset() {
  plant_ = std::make_unique<Plant>(scene_, model_);
  torques_ = {};
  gripper_force_ = 0;
  torques_set_at_.reset();
}

JointArray World::q() const {
  JointArray q;
  for (std::size_t i = 0; i < kArmJoints; ++i) q[i] = plant_->robot->body().getJointPos(plant_->arm[i]);
  return q;
}

JointArray World::dq() const {
  JointArray dq;
  for (std::size_t i = 0; i < kArmJoints; ++i) dq[i] = plant_->robot->body().getJointVel(plant_->arm[i]);
  return dq;
}

bool World::braked() const { return plant_->robot->braked(); }

void World::set_torques(const JointArray& torques) {
  for (const double torque : torques)
    if (!std::isfinite(torque)) throw std::domain_error("a torque for the arm is no finite number");
  const auto arm = model_.moved_by(Joint::Kind::revolute);
  for (std::size_t i = 0; i < kArmJoints; ++i) {
    const double limit = model_.links[static_cast<std::size_t>(arm[i])].joint.max_effort;
    torques_[i] = std::clamp(torques[i], -limit, limit);
  }
  torques_set_at_ = steps_;
}

double World::gripper_width() const {
  const btMultiBody& body = plant_->robot->body();
  return body.getJointPos(plant_->jaws[0]) + body.getJointPos(plant_->jaws[1]);
}

double World::gripper_speed() const {
  const btMultiBody& body = plant_->robot->body();
  return body.getJointVel(plant_->jaws[0]) + body.getJointVel(plant_->jaws[1]);
}

void World::set_gripper_force(double closing_force) {
  if (!std::isfinite(closing_force)) throw std::domain_error("a force for the gripper is no finite number");
  const int jaw = model_.moved_by(Joint::Kind::prismatic).front();
  const double limit = model_.links[static_cast<std::size_t>(jaw)].joint.max_effort;
  gripper_force_ = std::clamp(closing_force, -limit, limit);
}

bool World::has(std::string_view name) const { return plant_->part(name) || model_.link(name) >= 0; }

bool World::present(std::string_view name) const {
  const Part* part = plant_->part(name);
  return part ? part->present : model_.link(name) >= 0;
}

bool World::movable(std::string_view name) const {
  if (const Part* part = plant_->part(name)) return part->present && part->body->getInvMass() > 0;
  return plant_->carrier(name, model_) >= 0;
}

Pose World::pose(std::string_view name) const {
  assert(has(name));
  if (const Part* part = plant_->part(name)) return from_bullet(part->body->getWorldTransform());
  return plant_->robot->link_pose(model_.link(name));
}

void World::set_friction(std::string_view body, double friction) {
  const Part* part = plant_->part(body);
  assert(part && friction >= 0);
  part->body->setFriction(friction);
  plant_->wake();
  // Contacts that stick keep the coefficient they began with; they get the new one.
  for (int i = 0; i < plant_->dispatcher.getNumManifolds(); ++i) {
    btPersistentManifold* manifold = plant_->dispatcher.getManifoldByIndexInternal(i);
    const btCollisionObject* first = manifold->getBody0();
    const btCollisionObject* second = manifold->getBody1();
    if (first != part->body.get() && second != part->body.get()) continue;
    for (int k = 0; k < manifold->getNumContacts(); ++k)
      manifold->getContactPoint(k).m_combinedFriction = first->getFriction() * second->getFriction();
  }
}

void World::push(std::string_view name, const Vec3& force, const Vec3& point) {
  const btVector3 f(force[0], force[1], force[2]);
  const btVector3 p(point[0], point[1], point[2]);
  if (const Part* part = plant_->part(name)) {
    part->body->activate();
    part->body->applyForce(f, p - part->body->getCenterOfMassPosition());
    return;
  }
  const int index = plant_->carrier(name, model_);
  assert(index >= 0);
  btMultiBody& body = plant_->robot->body();
  const btVector3 com = body.getLink(index).m_cachedWorldTransform.getOrigin();
  body.addLinkForce(index, f);
  body.addLinkTorque(index, (p - com).cross(f));
}

void World::twist(std::string_view body, const Vec3& torque) {
  const Part* part = plant_->part(body);
  assert(part);
  part->body->activate();
  part->body->applyTorque({torque[0], torque[1], torque[2]});
}

Expected<void> World::check_part(std::string_view name) const {
  const Part* part = plant_->part(name);
  const std::string quoted = "`" + std::string(name) + "`";
  if (!part && model_.link(name) >= 0)
    return unexpected(ErrorCode::type, quoted + " is a link of the robot, which forces alone move", "part");
  if (!part) return unexpected(ErrorCode::not_found, "there is no part " + quoted, "part");
  if (part->body->getInvMass() == 0) return unexpected(ErrorCode::type, quoted + " is fixed", "part");
  return {};
}

Expected<void> World::place(std::string_view name, const Pose& o_t_part) {
  if (auto ok = check_part(name); !ok) return ok;
  Part& part = *plant_->part(name);
  btCollisionObject trial;
  trial.setCollisionShape(part.shape.get());
  trial.setWorldTransform(to_bullet(o_t_part));
  Intrusion intrusion(*part.body);
  intrusion.trial = &trial;
  plant_->world.updateAabbs();  // all are where the last step brought them
  plant_->world.contactTest(&trial, intrusion);
  if (intrusion.other)
    return unexpected(ErrorCode::conflict, "it would be inside `" + plant_->name_of(intrusion.other, model_) + "`",
                      "pose");
  // Out and in again: contacts of the old place are forgotten.
  if (part.present) plant_->world.removeRigidBody(part.body.get());
  btRigidBody& body = *part.body;
  body.setWorldTransform(trial.getWorldTransform());
  body.setInterpolationWorldTransform(trial.getWorldTransform());
  body.setLinearVelocity({0, 0, 0});
  body.setAngularVelocity({0, 0, 0});
  body.setInterpolationLinearVelocity({0, 0, 0});
  body.setInterpolationAngularVelocity({0, 0, 0});
  body.clearForces();
  plant_->world.addRigidBody(&body);
  plant_->wake();
  part.present = true;
  return {};
}

Expected<void> World::take(std::string_view name) {
  if (auto ok = check_part(name); !ok) return ok;
  Part& part = *plant_->part(name);
  if (!part.present) return unexpected(ErrorCode::conflict, "`" + part.name + "` was taken away already", "part");
  plant_->world.removeRigidBody(part.body.get());
  plant_->wake();
  part.present = false;
  return {};
}

double World::contact_force(std::string_view a, std::string_view b) const {
  const btCollisionObject* first = plant_->collider(a, model_);
  const btCollisionObject* second = plant_->collider(b, model_);
  double impulse = 0;
  for (int i = 0; i < plant_->dispatcher.getNumManifolds(); ++i) {
    const btPersistentManifold* manifold = plant_->dispatcher.getManifoldByIndexInternal(i);
    const bool same = manifold->getBody0() == first && manifold->getBody1() == second;
    const bool swapped = manifold->getBody0() == second && manifold->getBody1() == first;
    if (!same && !swapped) continue;
    for (int k = 0; k < manifold->getNumContacts(); ++k) impulse += manifold->getContactPoint(k).getAppliedImpulse();
  }
  return impulse / kStep;
}

}  // namespace race::world
