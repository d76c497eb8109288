// Gripper: the service `gripper`, two-finger force and position control. Operations, events and units: README.md.
//
// Threads: its group's. step() follows the world's step and sets the force of the next one.
#pragma once

#include "services/gripper/control_unit.h"
#include "services/table_component.h"
#include "services/world/world.h"

namespace race::gripper {

/// The RSM of every gripper.
const rsm::Service& model();

class Gripper final : public services::TableComponent {
 public:
  /// Drives the gripper of `world`. Both outlive the component.
  Gripper(services::ServiceHost& host, world::World& world);

  static const services::OperationTable& operations();
  void step() override;
  void halt() override;

 private:
  void grasp(const services::Call& call, const Dict& arguments);
  void release(const services::Call& call, const Dict& arguments);
  void stop(const services::Call& call);
  void report_state(const services::Call& call);
  void finish(Outcome outcome);
  Value state() const;

  world::World& world_;
  ControlUnit unit_;
  services::CallId moving_ = 0;  // the grasp or release that waits for its end; 0: none
};

}  // namespace race::gripper
