// ControlUnit: what runs in the robot's controller at 1 kHz (thesis 2.5): follows paths by one of four control laws,
// observes external forces, and reacts by reflex, without a task. It knows torques, positions and speeds of
// joints and where the arm keeps clear; no world, no RACE.
//
// Threads: one, its group's. control_unit.cpp has paths, laws and reactions, manual_motion.cpp what moves while a
// person holds a button.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "services/robot/arm_model.h"
#include "services/robot/behavior.h"
#include "services/robot/free_path.h"
#include "services/robot/held_button.h"
#include "services/robot/jogging.h"
#include "services/robot/observer.h"
#include "services/robot/path_follower.h"
#include "services/robot/planner.h"
#include "services/robot/rate_limit.h"
#include "services/robot/reflexes.h"
#include "services/robot/trajectory.h"

namespace race::robot {

struct ControlSettings {
  PlannerSettings planner;
  Joints braking{};             // rad/s2, of a stop
  Joints contact_thresholds{};  // Nm
  Joints damping{};             // Nms/rad, in gravity compensation
  double bandwidth = 60;        // rad/s, of the position controller (critically damped)
  double observer_gain = 50;    // 1/s
  int checks_per_cycle = 10;    // of clearance, about, while a free path is searched
  unsigned seed = 1;            // of the search for free paths
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
  /// Seconds that a call of jog() or guide() is good for.
  static constexpr double kJogHold = 0.25;

  /// Starts holding position at `q` with the usual behavior. Without `keeps_clear` no free path is planned.
  ControlUnit(ArmModel arm, const ControlSettings& settings, const Joints& q, KeepsClear keeps_clear = {});
  ControlUnit(const ControlUnit&) = delete;
  ControlUnit& operator=(const ControlUnit&) = delete;

  /// Begins a motion from where the arm holds, or will hold when it has braked; `behavior` acts from then on, else the
  /// present one. Refusals: those of plan(), `behavior` in gravity compensation, `busy` if it is moving. Nothing
  /// changes after a refusal. A free path is searched during the next cycles; its failure is an outcome.
  tl::expected<void, Refusal> move(const MoveCommand& command, const std::optional<Behavior>& behavior = {});

  /// Moves with a velocity from now on, and begins to slow down kJogHold after the last call: a person holds a button.
  /// Then, when the arm stands, the motion has ended as one that has reached its goal. Refusals: those of check_jog(),
  /// `behavior` in gravity compensation, `busy` during another motion; and after a reflex or something in the way has
  /// interrupted it the code of that, until nobody has called it for kJogHold: the person has let go. Nothing changes
  /// after a refusal, and it keeps no motion up.
  tl::expected<void, Refusal> jog(const JogVelocity& wanted);

  /// Gives way to a hand that leads the arm, with guided() of its behavior, until kJogHold after the last call: a
  /// person holds a button. Then it brakes with the largest deceleration and holds, with the behavior from before; when
  /// the arm stands, the motion has ended as one that has reached its goal. Refusals: `behavior` in gravity
  /// compensation, where nothing would brake it afterwards, `busy` during another motion; and after a reflex has
  /// interrupted it, or a jog(), as jog().
  tl::expected<void, Refusal> guide();

  /// Brakes with the largest deceleration and holds position, whatever it did, with held_by_position() of its behavior,
  /// of one that is guided of that from before. A motion ends without an outcome.
  void stop();

  /// Changes the behavior: brakes if it moves by hand, then holds where it is, or gives way. Torques
  /// blend gradually. Requires that it is not moving.
  void set_behavior(const Behavior& behavior);
  const Behavior& behavior() const { return behavior_; }

  /// Scales the speed of all motions, the present one too: 1 as planned, 0 pauses on the path. Requires 0..1.
  void set_override(double share) { override_ = share; }
  double speed_override() const { return override_; }

  /// The tool centre point keeps at or below this speed [m/s, at least 0; nothing: no limit] in whatever moves by this
  /// unit; what is faster slows down as fast as braking allows. A hand that leads the arm is not limited, braking not
  /// either.
  void set_tool_speed_limit(std::optional<double> tool_speed);

  /// One control cycle: takes the measured state, reacts, gives the torques for the next kPeriod.
  const Joints& control(const Joints& q, const Joints& dq);

  /// How a motion ended, once: no value in it means reached. Codes: `following_error` (pushed off its path; it then
  /// brakes and holds), `not_reached` (something keeps it from its goal), `path` (no free path), or the signal of the
  /// reflex that interrupted it.
  std::optional<std::optional<Refusal>> take_outcome();
  /// What began since they were taken last, in order.
  std::vector<Incident> take_incidents();

  /// Whether a motion has no outcome yet.
  bool moving() const { return returning_ || (activity_ != Activity::hold && activity_ != Activity::retreat); }
  RobotState state() const;
  const ArmModel& arm() const { return arm_; }

 private:
  /// hold: brakes, then stands (or, in gravity compensation, gives way); plan: holds, and searches a free path; guide:
  /// gives way while a button is held; settle: holds after that, and has not stood yet.
  enum class Activity { hold, plan, follow, retreat, jog, guide, settle };

  void react(const Incident& incident);
  void interrupt(const Refusal& why);
  void brake_and_hold();
  void hold_by_position();
  bool can_retreat() const;
  void search();
  void follow(Trajectory trajectory);
  Reference next_reference(const Joints& q, const Joints& dq);
  Reference follow_path(const Joints& q, const Joints& dq);
  Reference go_back(const Joints& q);
  void check_arrival(const Joints& q, const Joints& dq);
  Reference follow_jog(const Joints& q, const Joints& dq);
  void end_jog(const Joints& dq);
  bool stands(const Joints& dq);
  tl::expected<void, Refusal> check_let_go();
  void settle();
  void end_guided_behavior();
  void limit_rate();
  double limited(double rate) const;
  std::optional<double> jog_tool_speed() const;
  double rate() const;
  Joints law(const Joints& q, const Joints& dq);
  Joints position_law(const Joints& q, const Joints& dq, const Reference& reference) const;
  void blend_torques(Joints& torques);

  ArmModel arm_;
  ControlSettings settings_;
  KeepsClear keeps_clear_;
  Behavior behavior_ = usual_behavior(Mode::position);
  Joints q_{}, dq_{}, torques_{};
  Activity activity_ = Activity::hold;
  Braking brake_;                           // also the hold: a brake that has come to its end
  double brake_time_ = 0;                   // s since braking began
  std::optional<FreeSearch> search_;        // plan
  std::optional<PathFollower> path_;        // follow, retreat; in hold: the path at whose end it stands, if it does
  std::optional<double> tool_speed_limit_;  // m/s, of the reference
  std::optional<RateLimit> rate_limit_;     // of path_, if the tool's speed is limited
  std::optional<Jogging> jogging_;          // jog
  HeldButton button_;                       // that jogs or guides
  std::optional<Behavior> after_guiding_;   // guide: the behavior from before
  double overtime_ = 0;                     // s since the path's end, or since a jog or a guided arm should stand
  double override_ = 1;
  double slow_ = 1, slow_left_ = 0;   // of the reflexes: share of the speed, s that it still lasts
  double back_left_ = 0;              // m of the tool still to go back
  std::optional<Refusal> returning_;  // why the motion that goes back was interrupted
  std::optional<std::optional<Refusal>> outcome_;
  MomentumObserver observer_;
  Reflexes reflexes_;
  std::vector<Incident> incidents_;
  std::optional<Joints> offset_;  // torques at a change of behavior, less those of the new law
  double offset_left_ = 0;        // s
  unsigned searches_ = 0;
};

}  // namespace race::robot
