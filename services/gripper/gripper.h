// Gripper: the service `gripper`, two-finger force and position control. Operations, events and units: README.md.
//
// Threads: its group's. step() follows the world's step and sets the force of the next one.
#pragma once

#include "services/component.h"
#include "services/gripper/control_unit.h"
#include "services/world/world.h"

namespace race::gripper {

/// The RSM of every gripper.
const rsm::Service& model();

class Gripper final : public services::Component {
 public:
  /// Drives the gripper of `world`. Both outlive the component.
  Gripper(services::ServiceHost& host, world::World& world);

  const rsm::Service& model() const override { return gripper::model(); }
  void call(const services::Call& call) override;
  void step() override;

 private:
  void move(const services::Call& call);
  void stop(const services::Call& call);
  void finish(Outcome outcome);
  Value state() const;

  services::ServiceHost& host_;
  world::World& world_;
  ControlUnit unit_;
  services::CallId moving_ = 0;  // the grasp or release that waits for its end; 0: none
};

}  // namespace race::gripper
