// Collisions of the gripper's side with a body while the tool moves sideways: how soon the robot notices and answers a
// rigid one, and which force it puts on a clamped one. All in world time, so the same on every run.
// robot_bench prints them as the tables of services/robot/README.md; measured_test holds those tables to them.
// This is a simulation and says nothing about a real robot's safety.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "services/robot/behavior.h"

namespace race::robot {

/// What came of a collision with a fixed, rigid body.
struct Detection {
  double to_threshold;      // ms, from the first force between them to a residual above its contact threshold
  double to_command;        // ms, from there to torques that an arm without the reflex would not have commanded
  Severity at_once, worst;  // of the collision: as told first, and within 0.2 s
};

/// Speeds of the tool [m/s] for detect().
inline constexpr std::array kDetectionSpeeds = {0.05, 0.10, 0.20, 0.35, 0.50};

/// Collides with the body with the behavior `position` and its usual reflex, at this speed of the tool [m/s].
/// Throws std::runtime_error if no residual passes its threshold, or nothing is commanded differently.
Detection detect(double speed);

/// Forces on the hand and fingers of a person that ISO/TS 15066:2016, Table A.2, permits, N: clamped (quasi-static),
/// and for a moment (transient).
inline constexpr double kQuasiStatic = 140, kTransient = 280;

/// What the spring of a clamped body felt, N.
struct ClampForce {
  double peak;   // from the collision to 2 s after it
  double after;  // 2 s after it
};

/// One way to act when the robot collides with the clamped body. `reaction`: to any collision; none without a reflex.
struct Clamping {
  std::string mode;  // as the table names it
  std::optional<Reaction> reaction;
  Behavior behavior;

  std::string reaction_name() const;
};

/// Every mode with every reaction that it has, and an arm that is led by hand: the rows of the table.
std::vector<Clamping> clampings();

/// Speeds of the tool [m/s] for clamp().
inline constexpr std::array kClampSpeeds = {0.10, 0.25};

/// Brings the tool at `speed` [m/s] into a body as stiff and heavy as a hand (ISO/TS 15066:2016, Table A.3: 75 N/mm,
/// 0.6 kg) that is clamped to a wall by its spring: by the arm's own motion, or in gravity compensation by a hand that
/// then lets go. Throws std::runtime_error if they never collide.
ClampForce clamp(Behavior behavior, double speed);

}  // namespace race::robot
