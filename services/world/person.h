// Person: the hands of somebody who stands at the cell. A hand holds a link of the robot or a part at a point of it and
// draws that point towards a target by a spring and a damper, as an arm does; it pushes; as an experimenter the person
// also puts parts elsewhere and takes them away. The robot is moved by forces alone. Figures and sources: README.md.
//
// Threads: the world's. step() comes once before each World::step().
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "services/world/world.h"

namespace race::world {

/// How a hand holds.
struct Hold {
  static constexpr double kSoftest = 10, kStiffest = 5000;  // N/m
  static constexpr double kMostDamping = 100;               // Ns/m
  static constexpr double kStrongest = 250;                 // N
  static constexpr double kFarthest = 0.5;                  // m, of the point held from the origin of its body

  std::string body;        // a link of the robot or a part
  Vec3 point{};            // m, in the body's frame
  double stiffness = 500;  // N/m, kSoftest..kStiffest
  double damping = 20;     // Ns/m, 0..kMostDamping, against the held point's own speed
  double force = 100;      // N, 0..kStrongest: the hand gives way beyond
};

/// Where a hand draws what it holds.
struct Drag {
  static constexpr double kFastest = 2.0;  // m/s
  static constexpr std::size_t kPoints = 1000;

  std::vector<Vec3> path;   // m, in o; the target runs through these points in turn and stays at the last one
  double speed = kFastest;  // m/s of the target, at most kFastest
};

/// A force that rises evenly for `rise`, stays, falls evenly for `rise` and is over after `duration`.
struct Push {
  static constexpr double kLongest = 60;  // s

  std::string body;
  Vec3 force{};         // N, in o, at most Hold::kStrongest long
  Vec3 point{};         // m, in the body's frame; moves with the body
  double duration = 0;  // s, World::kStep..kLongest
  double rise = 0;      // s, 0..duration / 2. Slow is meant to be felt, fast is an accident
};

/// What can be seen of a hand, or of a push that is under way.
struct Touch {
  std::string body;
  Vec3 at{};                   // m, in o: where it touches
  Vec3 force{};                // N, in o: what it exerted in the last step
  std::optional<Vec3> target;  // m, in o; none: a push
};

class Person {
 public:
  static constexpr std::size_t kHands = 8;    // several people may be at the cell
  static constexpr std::size_t kPushes = 16;  // at a time

  explicit Person(World& world) : world_(world) {}

  /// The hand takes hold; what it held before it lets go. Until drag() its target is where the point is now. Errors,
  /// with the field as path: `not_found` (no such body), `conflict` (taken away; too many hands), `type` (cannot be
  /// moved), `out_of_range`.
  Expected<void> grab(const std::string& hand, const Hold& hold);
  /// The hand's target goes along a path, from where it is. Errors: `conflict` (the hand holds nothing),
  /// `out_of_range`.
  Expected<void> drag(const std::string& hand, const Drag& drag);
  /// The hand lets go by itself `timeout` seconds after its target has come to rest, unless it is dragged or told to
  /// keep again; infinity: never. So does the hand of somebody who is not there any more. Error: that of drag().
  Expected<void> keep(const std::string& hand, double timeout);
  /// The hand lets go; one that holds nothing stays so.
  void release(const std::string& hand);

  /// Begins a push. Errors: those of grab(); `conflict`: too many at once.
  Expected<void> push(const Push& push);

  /// World::place() and World::take(); hands let go of the part. The pose may be left out of a part that was taken
  /// away: where it was.
  Expected<void> place(const std::string& part, const std::optional<Pose>& o_t_part);
  Expected<void> take(const std::string& part);

  /// All hands let go, and pushes end.
  void let_go() {
    hands_.clear();
    pushes_.clear();
  }

  /// The forces of the world's next step.
  void step();

  /// Hands that hold something, by name, and pushes under way, each "push".
  std::vector<std::pair<std::string, Touch>> touches() const;

 private:
  struct Hand {
    Hold hold = {};
    double stiffness = 0, damping = 0;  // N/m, Ns/m: as the body bears them
    Pose held = {};                     // of a part, as it was grabbed: its orientation is kept
    Pose last = {};                     // of the body one step ago
    std::vector<Vec3> path = {};        // still to come, the next point last
    double speed = 0;                   // m/s
    double timeout = 0;                 // s
    double idle_since = 0;              // s of world time
    Touch touch = {};
  };
  struct Pushing {
    Push push;
    double begin;  // s of world time
    Touch touch;
  };

  Expected<void> check_body(const std::string& body, const Vec3& point) const;
  Expected<Hand*> find(const std::string& hand);
  void let_go_of(const std::string& part);
  void pull(Hand& hand);
  void keep_orientation(const Hand& hand, const Pose& now);

  World& world_;
  std::map<std::string, Hand> hands_;
  std::vector<Pushing> pushes_;
};

}  // namespace race::world
