// ControlUnit: what runs in the robot's controller at 1 kHz: follows trajectories by computed torque, brakes,
// compensates gravity, observes external forces. It knows torques, positions and speeds of joints; no world, no RACE.
//
// Threads: one, its unit's.
#pragma once

#include <optional>

#include "services/robot/arm_model.h"
#include "services/robot/observer.h"
#include "services/robot/planner.h"
#include "services/robot/trajectory.h"

namespace race::robot {

enum class Behavior {
  position,              // follows its reference stiffly
  gravity_compensation,  // carries its own weight and can be led by hand
};

struct ControlSettings {
  PlannerSettings planner;
  Joints braking{};             // rad/s2, of a stop
  Joints contact_thresholds{};  // Nm
  Joints damping{};             // Nms/rad, in gravity compensation
  double bandwidth = 60;        // rad/s, of the position controller (critically damped)
  double observer_gain = 50;    // 1/s
};

/// The settings of the demonstrator's LWR; their reasons stand in README.md.
ControlSettings lwr_settings();

/// A sample of everything the control unit knows.
struct RobotState {
  Joints q{}, dq{};  // rad, rad/s
  Joints tau{};      // Nm, commanded last
  Joints tau_ext{};  // Nm, estimated
  Pose pose;         // tool centre point in o
  Wrench external;   // at the tool centre point, in o, estimated
};

class ControlUnit {
 public:
  /// Seconds between two calls of control().
  static constexpr double kPeriod = 0.001;

  /// Starts holding position at `q`.
  ControlUnit(ArmModel arm, const ControlSettings& settings, const Joints& q);
  ControlUnit(const ControlUnit&) = delete;
  ControlUnit& operator=(const ControlUnit&) = delete;

  /// Begins a motion from where the arm holds, or will hold when it has braked. Refusals: those of plan(), and
  /// `behavior` if it is not in position control, `busy` if it is moving. Nothing moves after a refusal.
  tl::expected<void, Refusal> move(const MoveCommand& command);

  /// Brakes with the largest deceleration and holds, whatever it did. A motion is forgotten, without an outcome.
  void stop();

  /// Changes the behavior; from gravity compensation it first brakes, then holds. Requires that it is not moving.
  void set_behavior(Behavior behavior);
  Behavior behavior() const { return behavior_; }

  /// One control cycle: takes the measured state, gives the torques for the next kPeriod.
  const Joints& control(const Joints& q, const Joints& dq);

  /// How a motion ended, once: no value in it means reached. Codes: `following_error` (pushed off its path; it then
  /// brakes and holds), `not_reached` (something keeps it from its goal).
  std::optional<std::optional<Refusal>> take_outcome();
  /// A contact that began, once.
  std::optional<Contact> take_contact();

  bool moving() const { return motion_.has_value(); }
  RobotState state() const;
  const ArmModel& arm() const { return arm_; }

 private:
  Reference next_reference(const Joints& q, const Joints& dq);
  void judge_arrival(double overtime, const Joints& q, const Joints& dq);
  void fail(Refusal refusal);

  ArmModel arm_;
  ControlSettings settings_;
  Behavior behavior_ = Behavior::position;
  Joints q_{}, dq_{}, torques_{};
  Braking brake_;                     // also the hold: a brake that has come to its end
  double brake_time_ = 0;             // s since braking began
  std::optional<Trajectory> motion_;  // starts when the brake has come to its end
  double motion_time_ = 0;
  std::optional<std::optional<Refusal>> outcome_;
  MomentumObserver observer_;
  ContactDetector detector_;
  std::optional<Contact> contact_;
};

}  // namespace race::robot
