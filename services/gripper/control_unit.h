// ControlUnit: what runs in the gripper's controller at 1 kHz: closes until the fingers meet something, holds with a
// force, opens to a width. It knows the width, its speed and the drive's force; no world, no RACE.
//
// Threads: one, its group's.
#pragma once

#include <optional>

namespace race::gripper {

inline constexpr double kStroke = 0.110;      // m, largest width (data sheet WSG 50)
inline constexpr double kLeastForce = 5.0;    // N
inline constexpr double kMostForce = 80.0;    // N
inline constexpr double kLeastSpeed = 0.005;  // m/s of the width
inline constexpr double kMostSpeed = 0.420;   // m/s

/// How a grasp or a release ended.
enum class Outcome {
  held,     // the fingers hold something with the force
  no_part,  // they came to the width and met nothing
  opened,   // they are at the width
  blocked,  // something keeps them from opening to the width
};

class ControlUnit {
 public:
  /// Begins at `width`, holding it.
  explicit ControlUnit(double width);

  /// Closes with `speed` until the fingers meet something, or are kTolerance less than `width` apart. Requires a width
  /// of 0..kStroke, kLeastSpeed..kMostSpeed, kLeastForce..kMostForce.
  void grasp(double width, double speed, double force);
  /// Opens, or closes without force, to `width`.
  void release(double width, double speed);
  /// Stands still at once; a part that is held stays held.
  void stop();

  /// One control cycle: takes the measured width and its speed, gives the closing force [N] for the next millisecond.
  double control(double width, double speed);

  /// How the last grasp or release ended, once.
  std::optional<Outcome> take_outcome();
  /// Whether a held part was lost since the last call.
  bool take_loss();

  bool holding() const { return phase_ == Phase::hold; }
  double width() const { return width_; }

 private:
  /// rest: holds a width; close: towards a part; clamp: builds up the force; hold: keeps it; open: towards a width.
  enum class Phase { rest, close, clamp, hold, open };

  double close();
  double clamp();
  double hold();
  double open();
  double towards(double width, double largest_speed) const;
  bool stalled();
  void rest_at(double width);

  Phase phase_ = Phase::rest;
  double width_, speed_ = 0;      // measured
  double target_ = 0, pace_ = 0;  // m, m/s
  double force_ = 0;              // N
  double held_width_ = 0;         // m, when the force had been built up
  int elapsed_ = 0;               // ms that the fingers have not moved, or the force has been on
  std::optional<Outcome> outcome_;
  bool lost_ = false;
};

}  // namespace race::gripper
