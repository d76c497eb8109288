// HeldOperation: an operation that is called again and again while a person holds a button (rsm::Operation::held), as
// `jog` and `guide` of a robot are. Which of its calls are one motion, and which come of a button that was pressed
// under a permission that has ended since.
//
// Threads: one at a time.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "server/control/control.h"

namespace race::server {

class HeldOperation {
 public:
  using Steady = Control::Steady;
  static constexpr std::chrono::seconds kOneMotion{1};  // calls that follow each other sooner are one motion

  /// A call to `service` came, with the fencing number `fence`. Whether its button is held since another number was
  /// given: what ended that permission (a stop, another mode) ended the motion, and whoever resets the stop, the button
  /// moves nothing until it is let go of: until no such call has come for as long as a person may be silent.
  bool is_held_over(const std::string& service, std::uint64_t fence, Steady now);
  /// Somebody has stopped what `service` moves: a button that is held moves nothing until it is let go of.
  void end(const std::string& service);
  static constexpr std::size_t kMostServices = 16;  // of more, the one that was called the longest ago is forgotten

  /// A call that is let through. Whether it begins a motion, or goes on with one.
  bool begins(const std::string& service, const std::string& operation, Steady now);
  /// Whether a motion of `service` may still go on.
  bool goes_on(const std::string& service, Steady now) const;

 private:
  struct Button {
    std::string operation;    // of the last motion
    Steady moved = {};        // when it was let through last
    Steady heard = {};        // when it was called last, let through or not
    std::uint64_t fence = 0;  // with which it was pressed; 0, which no call has: ended since
  };
  Button& button_of(const std::string& service);

  std::map<std::string, Button> buttons_;  // by service
};

}  // namespace race::server
