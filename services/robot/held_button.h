// HeldButton: the dead-man of manual motion. A person holds a button, and whoever speaks for it calls again and again;
// when no call has come for a while, the button is let go of, whatever the reason. After an interruption it must be let
// go of before it counts again.
#pragma once

#include <optional>
#include <utility>

#include "services/robot/planner.h"

namespace race::robot {

class HeldButton {
 public:
  /// Let go of that many control cycles after the last call.
  explicit HeldButton(int cycles) : cycles_(cycles) {}

  void call() { cycles_left_ = cycles_; }
  bool held() const { return cycles_left_ > 0; }
  /// One control cycle is over.
  void pass() {
    if (!held()) interruption_.reset();
    if (held()) --cycles_left_;
  }

  void interrupt(Refusal why) { interruption_ = std::move(why); }
  /// What has interrupted the motion, until the button is let go of.
  const std::optional<Refusal>& interruption() const { return interruption_; }

 private:
  int cycles_;
  int cycles_left_ = 0;
  std::optional<Refusal> interruption_;
};

}  // namespace race::robot
