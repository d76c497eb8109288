// Robot: the service `robot` (thesis Figure 4.1): offers a control unit to tasks. Operations, events and units:
// README.md.
//
// Threads: its group's. step() follows the world's step and sets the torques of the next one.
#pragma once

#include <optional>
#include <string_view>

#include "services/robot/control_unit.h"
#include "services/table_component.h"
#include "services/world/clearance.h"
#include "services/world/world.h"

namespace race::robot {

/// The RSM of every robot.
const rsm::Service& model();

class Robot final : public services::TableComponent {
 public:
  /// Drives the arm of `world`. Both outlive the component. `seed` is that of the search for free paths. Error `type`:
  /// the world's robot is no such arm.
  static Expected<std::unique_ptr<Robot>> create(services::ServiceHost& host, world::World& world, unsigned seed = 1);

  static const services::OperationTable& operations();
  void step() override;
  void halt() override;
  void limit_speed(std::optional<double> tool_speed) override;
  void demand_changed(std::string_view flow, bool on) override;

 protected:
  void refuse_arguments(const services::Call& call, const Error& error) override;

 private:
  Robot(services::ServiceHost& host, world::World& world, ArmModel arm, unsigned seed);

  void move(const services::Call& call, const Dict& arguments);
  void jog(const services::Call& call, const Dict& arguments);
  void guide(const services::Call& call, const Dict& arguments);
  void refuse_held(const services::Call& call, const Refusal& refusal);
  void end_refused(const services::Call& call);
  void set_payload(const std::optional<Vec3>& part);
  void explain_standstill();
  void stop(const services::Call& call);
  void change_behavior(const services::Call& call, const Dict& arguments);
  void speed_override(const services::Call& call, const Dict& arguments);
  void record_pose(const services::Call& call, const Dict& arguments);
  void report_state(const services::Call& call);
  Value place() const;
  void finish_move(const std::optional<Refusal>& failure);
  void finish(const std::optional<Refusal>& failure);
  void announce(const Incident& incident);
  void publish_control();

  world::World& world_;
  world::Clearance clearance_;                              // of the arm without payload
  std::optional<world::Clearance> clearance_with_payload_;  // of the arm and the payload of the last move
  ControlUnit unit_;
  services::CallId moving_ = 0;  // the move that waits for its end; 0: none
  std::string_view held_;        // the transition that ends the state Jogging or Guiding; empty: in neither
  Value collision_;              // the last one, as the flow `control` tells it; null: none yet
  bool watched_ = false;         // somebody listens to the flow `control`
};

}  // namespace race::robot
