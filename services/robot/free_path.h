// FreePath: searches a way for the arm around what stands in the cell, by RRT-Connect (J. Kuffner, S. LaValle,
// "RRT-Connect: an efficient approach to single-query path planning", ICRA 2000), and shortens and smooths it. It works
// in slices, so that it can run within a control loop; the same seed searches the same way.
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "services/robot/arm_model.h"

namespace race::robot {

/// Whether the arm may be at these joint positions. What a search costs is counted in its calls.
using Allowed = std::function<bool(const Joints&)>;

class FreePath {
 public:
  /// A path has a place at least every kResolution (Euclidean norm of joint positions, rad), each of them allowed.
  static constexpr double kResolution = 0.05;
  static constexpr int kMostChecks = 60'000;  // of a search; then it has failed

  /// Requires that `start` and `goal` are allowed and within `limits`.
  FreePath(const JointLimits& limits, Allowed allowed, const Joints& start, const Joints& goal, unsigned seed);

  enum class State { searching, found, failed };
  /// Goes on for about `checks` calls of `allowed`: the last step may take some more.
  State work(int checks);
  /// Places from start to goal, evenly spaced. Requires `found`.
  const std::vector<Joints>& places() const { return places_; }
  int checks() const { return checks_; }

 private:
  struct Node {
    Joints q{};
    int parent = -1;
  };
  using Tree = std::vector<Node>;

  bool check(const Joints& q);
  bool free_between(const Joints& from, const Joints& to);
  Joints sample();
  /// Grows `tree` towards `target` by at most one step; the index of the new node, none if something is in the way.
  std::optional<int> extend(Tree& tree, const Joints& target);
  void grow();
  void join(int in_first, int in_second);
  void shorten();
  void smooth();

  JointLimits limits_;
  Allowed allowed_;
  std::mt19937 random_;
  std::array<Tree, 2> trees_;    // from the start, from the goal
  std::size_t turn_ = 0;         // the tree that grows next
  std::vector<Joints> corners_;  // of the path found, shortened
  std::vector<Joints> places_;
  int checks_ = 0;
  int shortcuts_ = 0;
  State state_ = State::searching;
};

}  // namespace race::robot
