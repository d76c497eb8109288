// RobotModel to KDL chain; forward kinematics, Jacobian, recursive Newton-Euler, mass matrix.
#include "services/robot/arm_model.h"

#include <algorithm>
#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <vector>

namespace race::robot {
namespace {

const KDL::Vector kGravity(0, 0, -9.81);  // m/s2, in o

KDL::Vector to_kdl(const Vec3& v) { return {v[0], v[1], v[2]}; }

KDL::Frame to_kdl(const Pose& pose) {
  const auto& q = pose.orientation;
  return {KDL::Rotation::Quaternion(q[0], q[1], q[2], q[3]), to_kdl(pose.position)};
}

KDL::JntArray to_kdl(const Joints& joints) {
  KDL::JntArray array(kJoints);
  for (unsigned i = 0; i < kJoints; ++i) array(i) = joints[i];
  return array;
}

Joints from_kdl(const KDL::JntArray& array) {
  Joints joints;
  for (unsigned i = 0; i < kJoints; ++i) joints[i] = array(i);
  return joints;
}

KDL::RigidBodyInertia own_inertia(const world::Link& link) {
  if (link.mass == 0) return KDL::RigidBodyInertia::Zero();
  return KDL::RigidBodyInertia(link.mass, to_kdl(link.com),
                               KDL::RotationalInertia(link.inertia[0], link.inertia[1], link.inertia[2]));
}

/// Link pose in its parent with a moving joint at `position`.
KDL::Frame at(const world::Joint& joint, double position) {
  KDL::Frame motion = KDL::Frame::Identity();
  if (joint.kind == world::Joint::Kind::prismatic) motion.p = to_kdl(joint.axis) * position;
  if (joint.kind == world::Joint::Kind::revolute) motion.M = KDL::Rotation::Rot(to_kdl(joint.axis), position);
  return to_kdl(joint.parent_t_joint) * motion;
}

/// Inertia of a link and of everything that hangs on it beside the chain, in the link's frame.
KDL::RigidBodyInertia inertia_with_side_links(const world::RobotModel& model, int link, const std::vector<int>& chain) {
  KDL::RigidBodyInertia sum = own_inertia(model.links[static_cast<std::size_t>(link)]);
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    const world::Link& child = model.links[i];
    const int index = static_cast<int>(i);
    if (child.parent != link || std::find(chain.begin(), chain.end(), index) != chain.end()) continue;
    const double middle = (child.joint.lower + child.joint.upper) / 2;
    sum = sum + at(child.joint, middle) * inertia_with_side_links(model, index, chain);
  }
  return sum;
}

}  // namespace

struct ArmModel::Chain {
  explicit Chain(KDL::Chain source)
      : chain(std::move(source)), position(chain), velocity(chain), torques(chain, kGravity), parts(chain, kGravity) {}

  KDL::Chain chain;  // the solvers refer to it
  KDL::ChainFkSolverPos_recursive position;
  KDL::ChainJntToJacSolver velocity;
  KDL::ChainIdSolver_RNE torques;
  KDL::ChainDynParam parts;
  KDL::Wrenches no_wrenches{chain.getNrOfSegments(), KDL::Wrench::Zero()};
};

ArmModel::ArmModel() = default;
ArmModel::~ArmModel() = default;
ArmModel::ArmModel(ArmModel&&) noexcept = default;
ArmModel& ArmModel::operator=(ArmModel&&) noexcept = default;

Expected<ArmModel> ArmModel::create(const world::RobotModel& model, const Pose& o_t_base, std::string_view tip) {
  std::vector<int> links;
  for (int link = model.link(tip); link > 0; link = model.links[static_cast<std::size_t>(link)].parent)
    links.insert(links.begin(), link);
  if (links.empty()) return unexpected(ErrorCode::not_found, "no link '" + std::string(tip) + "'", model.name);

  ArmModel arm;
  KDL::Chain chain;
  chain.addSegment(KDL::Segment("base", KDL::Joint(KDL::Joint::Fixed), to_kdl(o_t_base)));
  std::size_t joint_count = 0;
  for (const int index : links) {
    const world::Link& link = model.links[static_cast<std::size_t>(index)];
    const KDL::Frame origin = to_kdl(link.joint.parent_t_joint);
    KDL::Joint joint(link.joint.name, KDL::Joint::Fixed);
    if (joint_count > 1) arm.reach_ += origin.p.Norm();
    if (link.joint.kind != world::Joint::Kind::fixed) {
      if (link.joint.kind != world::Joint::Kind::revolute || joint_count == kJoints)
        return unexpected(ErrorCode::type, "the arm needs exactly seven revolute joints", model.name);
      joint = KDL::Joint(link.joint.name, origin.p, origin.M * to_kdl(link.joint.axis), KDL::Joint::RotAxis);
      arm.limits_.lower[joint_count] = link.joint.lower;
      arm.limits_.upper[joint_count] = link.joint.upper;
      arm.limits_.velocity[joint_count] = link.joint.max_velocity;
      arm.limits_.effort[joint_count] = link.joint.max_effort;
      arm.links_[joint_count++] = link.name;
    }
    chain.addSegment(KDL::Segment(link.name, joint, origin, inertia_with_side_links(model, index, links)));
    if (joint_count == 2 && link.joint.kind != world::Joint::Kind::fixed) {
      KDL::Frame shoulder;
      KDL::ChainFkSolverPos_recursive(chain).JntToCart(KDL::JntArray(2), shoulder);
      arm.shoulder_ = {shoulder.p.x(), shoulder.p.y(), shoulder.p.z()};
    }
  }
  if (joint_count != kJoints)
    return unexpected(ErrorCode::type, "the arm needs exactly seven revolute joints", model.name);
  arm.chain_ = std::make_unique<Chain>(std::move(chain));
  return arm;
}

Pose ArmModel::forward(const Joints& q) const {
  KDL::Frame frame;
  chain_->position.JntToCart(to_kdl(q), frame);
  Pose pose{{frame.p.x(), frame.p.y(), frame.p.z()}, {}};
  frame.M.GetQuaternion(pose.orientation[0], pose.orientation[1], pose.orientation[2], pose.orientation[3]);
  return pose;
}

Jacobian ArmModel::jacobian(const Joints& q) const {
  KDL::Jacobian source(kJoints);
  chain_->velocity.JntToJac(to_kdl(q), source);
  Jacobian jacobian;
  for (unsigned row = 0; row < 6; ++row) {
    for (unsigned column = 0; column < kJoints; ++column) jacobian[row][column] = source(row, column);
  }
  return jacobian;
}

Joints ArmModel::inverse_dynamics(const Joints& q, const Joints& dq, const Joints& ddq) const {
  KDL::JntArray torques(kJoints);
  chain_->torques.CartToJnt(to_kdl(q), to_kdl(dq), to_kdl(ddq), chain_->no_wrenches, torques);
  return from_kdl(torques);
}

Joints ArmModel::gravity(const Joints& q) const {
  KDL::JntArray torques(kJoints);
  chain_->parts.JntToGravity(to_kdl(q), torques);
  return from_kdl(torques);
}

Joints ArmModel::coriolis(const Joints& q, const Joints& dq) const {
  KDL::JntArray torques(kJoints);
  chain_->parts.JntToCoriolis(to_kdl(q), to_kdl(dq), torques);
  return from_kdl(torques);
}

MassMatrix ArmModel::mass(const Joints& q) const {
  KDL::JntSpaceInertiaMatrix source(kJoints);
  chain_->parts.JntToMass(to_kdl(q), source);
  MassMatrix mass;
  for (unsigned row = 0; row < kJoints; ++row) {
    for (unsigned column = 0; column < kJoints; ++column) mass[row][column] = source(row, column);
  }
  return mass;
}

}  // namespace race::robot
