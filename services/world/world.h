// World: the plant of a cell, a Bullet multibody world with the robot, its gripper, the table and the parts. It is no
// RACE service: control units read its sensors and set its torques and forces; nothing writes a position of the robot
// but reset(). Parts may be put elsewhere by an experimenter, never into another body.
//
// Threads: one thread, its group's. It has no clock: its time is the number of steps its caller made.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "services/world/pose.h"
#include "services/world/robot_model.h"
#include "services/world/scene.h"

namespace race::world {

inline constexpr std::size_t kArmJoints = 7;
using JointArray = std::array<double, kArmJoints>;

class World {
 public:
  /// Seconds of world time that one step() advances.
  static constexpr double kStep = 0.001;

  /// Builds the world of `scene` with the robot `model` (the URDF that the scene names). The model needs seven revolute
  /// joints in a chain and two prismatic ones, the jaws; errors `type` and `duplicate` (a body named as a link),
  /// `out_of_range` (a start posture outside of the joint limits).
  static Expected<std::unique_ptr<World>> create(const Scene& scene, const RobotModel& model);

  /// Reads the scene file and its URDF and builds their world.
  static Expected<std::unique_ptr<World>> load(const std::string& scene_path);

  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  const Scene& scene() const { return scene_; }
  const RobotModel& model() const { return model_; }

  /// Advances world time by kStep under the torques and forces set last, or with closed brakes: see braked().
  void step();

  /// Seconds since the start, exactly steps() * kStep.
  double time() const { return static_cast<double>(steps_) * kStep; }
  std::int64_t steps() const { return steps_; }

  /// Everything is as the scene says again, at rest, without torques, forces and contacts: the plant is built anew.
  /// Time goes on. What the control units of before know is no longer so; others are to take their place before the
  /// next step.
  void reset();

  // The robot's sensors and actuators. The drives saturate at the model's effort limits. What is not finite reaches no
  // drive: it throws std::domain_error, and counts as not set.
  JointArray q() const;                                   // rad
  JointArray dq() const;                                  // rad/s
  void set_torques(const JointArray& torques);            // Nm
  const JointArray& torques() const { return torques_; }  // Nm, as applied; none while it is braked

  /// How many steps torques hold without being set anew: a controller sets them at each.
  static constexpr std::int64_t kTorqueTimeoutSteps = 10;
  /// Whether the arm has no controller any more: torques were set once, but not for kTorqueTimeoutSteps. A holding
  /// brake at each joint has closed then, until torques are set again. The gripper's force holds until it is set anew.
  bool braked() const;

  /// The gripper's one drive: the jaws move against each other, held in step by their rack and pinion.
  double gripper_width() const;                  // m between the finger pads
  double gripper_speed() const;                  // m/s of the width, negative while closing
  void set_gripper_force(double closing_force);  // N, on each finger; negative opens

  /// Where a body of the scene or a link of the robot is, seen from o; of a part that was taken away, where it was.
  /// Requires such a name: see has().
  Pose pose(std::string_view name) const;
  bool has(std::string_view name) const;
  /// Whether it is in the cell: has(), and not taken away.
  bool present(std::string_view name) const;

  // What an experimenter in the cell can do; control units do not use it.

  /// Changes the coefficient of friction of a body of the scene. Requires such a body and friction >= 0.
  void set_friction(std::string_view body, double friction);
  /// Whether a force can move it: a part that is present and not fixed, a link on a joint of the robot.
  bool movable(std::string_view name) const;
  /// Pushes a movable body or a link with `force` [N, in o] at `point` [m, in o] during the next step.
  void push(std::string_view name, const Vec3& force, const Vec3& point);
  /// Turns a movable body of the scene with `torque` [Nm, in o] during the next step.
  void twist(std::string_view body, const Vec3& torque);

  /// How deep a part may be put into another body: 1 mm, for poses that are written with few digits.
  static constexpr double kDeepest = 0.001;
  /// Puts a part at rest at a pose, back into the cell if it was taken away. Nothing happens on errors: `not_found`,
  /// `type` (a link, or a body that is fixed), `conflict` (inside another body, which the message names).
  Expected<void> place(std::string_view part, const Pose& o_t_part);
  /// Takes a part out of the cell. Errors: `not_found`, `type`, `conflict` (it is not there).
  Expected<void> take(std::string_view part);
  /// Sum of the normal forces [N] between two bodies or links during the last step.
  double contact_force(std::string_view a, std::string_view b) const;

 private:
  struct Plant;
  Expected<void> check_part(std::string_view name) const;
  World(const Scene& scene, const RobotModel& model);

  Scene scene_;
  RobotModel model_;
  JointArray torques_{};
  double gripper_force_ = 0;
  std::int64_t steps_ = 0;
  std::optional<std::int64_t> torques_set_at_;  // step before which torques were set last
  std::unique_ptr<Plant> plant_;                // Bullet's objects, known to world.cpp alone
};

}  // namespace race::world
