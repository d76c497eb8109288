// Builds Bullet's view of a RobotModel and of a Shape. For the .cpp files of this folder.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "services/world/robot_model.h"
#include "services/world/scene.h"

class btCollisionShape;
class btMultiBody;
class btMultiBodyConstraint;
class btMultiBodyDynamicsWorld;
class btMultiBodyJointMotor;
class btMultiBodyLinkCollider;
class btTransform;

namespace race::world {

btTransform to_bullet(const Pose& pose);
Pose from_bullet(const btTransform& transform);

std::unique_ptr<btCollisionShape> make_shape(const Shape& shape);

/// The robot in Bullet: link i + 1 of the model is link i of the multibody, its frame is at its centre of mass. Frames
/// without mass at the end of the chain are no links of the multibody; `host` and `host_t_link` say where they sit.
class Robot {
 public:
  Robot(const RobotModel& model, const Mounting& mounting, btMultiBodyDynamicsWorld& world);
  ~Robot();
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  btMultiBody& body() { return *body_; }
  const btMultiBody& body() const { return *body_; }
  /// Bullet's index of a link of the model: -1 is the base.
  int bullet_index(int link) const { return bullet_index_[static_cast<std::size_t>(link)]; }
  /// Pose of a link's frame (not its centre of mass) seen from o, after the last update_frames().
  Pose link_pose(int link) const;
  /// Recomputes the link frames from the joint positions.
  void update_frames();
  /// Closes the holding brakes of the revolute joints, or opens them; at each step. A brake takes as much torque as its
  /// drive can give.
  void set_brakes(bool closed);
  bool braked() const { return braked_; }

 private:
  void add_collider(const Link& link, int index, double friction);

  const RobotModel& model_;
  btMultiBodyDynamicsWorld& world_;
  std::vector<int> bullet_index_;
  std::unique_ptr<btMultiBody> body_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::vector<std::unique_ptr<btMultiBodyConstraint>> end_stops_;
  struct Brake {
    int index;  // of Bullet's link
    std::unique_ptr<btMultiBodyJointMotor> motor;
    std::optional<double> sticks_at;  // rad; none: it slides
  };
  std::vector<Brake> brakes_;
  bool braked_ = false;
};

}  // namespace race::world
