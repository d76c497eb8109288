// Goals: where an execution stops between micro steps. How far a step goes is one; a breakpoint is one that stays.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/semantics/correspondence.h"
#include "core/semantics/run.h"

namespace race::execution {

struct Goal {
  enum class Kind : std::uint8_t {
    micro,    // after one micro step
    macro,    // at the end of the macro step
    entered,  // the state has been activated
    left,     // an activation of the state has ended: one that is under way, or that begins from now on
    fired,    // the port has fired
  } kind = Kind::micro;
  semantics::StateId state = semantics::kNoState;  // of `entered` and `left`
  semantics::PortId port = semantics::kNoPort;     // of `fired`
  bool operator==(const Goal&) const = default;
};

/// A goal as people and clients name it: the state or port by its id (meta.id) or by its path.
struct GoalName {
  Goal::Kind kind = Goal::Kind::micro;
  std::optional<std::string> id = {};
  std::string path = {};
  bool operator==(const GoalName&) const = default;
};

/// "micro", "entered" and so on.
std::string_view name(Goal::Kind kind);

/// Error `not_found`: the program has no such state or port.
Expected<Goal> find_goal(const semantics::Program& program, const GoalName& name);

/// Whether a goal has been reached since it was set.
class GoalWatch {
 public:
  GoalWatch(Goal goal, const semantics::Run& run) : goal_(goal) { set(run); }
  const Goal& goal() const { return goal_; }
  /// To be asked after each micro step. One that is reached counts anew from there.
  bool reached(const semantics::Run& run);
  /// The same in an edited program. False: it has no such state or port.
  bool carry_over(const semantics::Correspondence& same);

 private:
  void set(const semantics::Run& run);

  Goal goal_;
  std::uint32_t activations_ = 0;  // of the state, when it was set
  bool active_ = false;            // whether the state or port was active then
};

}  // namespace race::execution
