// Goals: where an execution stops between micro steps. How far a step goes is one; a breakpoint is one that stays.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/execution/micro_step_facts.h"
#include "core/semantics/correspondence.h"
#include "core/semantics/run.h"

namespace race::execution {

struct Goal {
  enum class Kind : std::uint8_t {
    micro,      // after one micro step
    macro,      // at the end of the macro step
    entered,    // the state has been activated
    left,       // an activation of the state has ended: one that is under way, or that begins from now on
    into,       // a state within the state has been activated, or as `left`
    fired,      // the port has fired
    tested,     // the condition of the port has been evaluated; it is not while nothing has happened in which its state
                // could take part
    executed,   // the action, or any of the state, has been executed
    called,     // an operation has been called, by the state or within it
    fault,      // the state, or one within it, is the one in which the run faults; always `before`
    fulfilled,  // the condition has become fulfilled while the state is active
  } kind = Kind::micro;
  /// Before the micro step that would reach it, instead of after it.
  bool before = false;
  semantics::StateId state = semantics::kNoState;  // in whose scope `condition` is; of all but `micro` and `macro`
  semantics::PortId port = semantics::kNoPort;     // of `fired` and `tested`
  semantics::ActionId action = semantics::kNone;   // of `executed`; kNone: any of the state
  std::string service = {}, operation = {};        // of `called`; empty: any
  /// What has to hold, too: before the micro step or after it, as `before` says. Empty: nothing.
  semantics::Code condition = {};
  bool operator==(const Goal& other) const;
};

/// A goal as people and clients name it: the state, port or action by its id (meta.id) or by its path (an action has no
/// path: that of a state means any action of it). `called` and `fault` need neither: the root then.
struct GoalName {
  Goal::Kind kind = Goal::Kind::micro;
  std::optional<std::string> id = {};
  std::string path = {};
  bool before = false;
  std::string service = {}, operation = {};
  std::string condition = {};
  bool operator==(const GoalName&) const = default;
};

/// "micro", "entered" and so on.
std::string_view name(Goal::Kind kind);

/// Errors, at the fields of api/schemas/breakpoints.json: `not_found`: the program has no such state, port or action,
/// or calls no such operation; those of semantics::compile_condition.
Expected<Goal> find_goal(const semantics::Program& program, const GoalName& name);

/// Whether a goal has been reached since it was set.
class GoalWatch {
 public:
  GoalWatch(Goal goal, semantics::Run& run) : goal_(std::move(goal)) { set(run); }
  const Goal& goal() const { return goal_; }
  /// Whether what the micro step has done must be known.
  bool needs_facts() const { return goal_.before || goal_.kind >= Goal::Kind::tested; }
  /// To be asked after each micro step, with what it did if needs_facts(). One that is reached counts anew from there.
  bool reached(semantics::Run& run, const MicroStepFacts* facts);
  /// Whether the execution stops before the micro step from `run` to `ahead`: only once, until it is done.
  bool stops_before(semantics::Run& run, semantics::Run& ahead, const MicroStepFacts& facts);
  /// Has stopped, before a micro step that is not done yet, as `other` has.
  void take_stop(const GoalWatch& other) { has_stopped_ = has_stopped_ || other.has_stopped_; }
  /// The same in an edited program. False: it has no such state, port or action, or the condition means nothing there.
  bool carry_over(const semantics::Correspondence& same, const semantics::Program& program);

 private:
  void set(semantics::Run& run);
  bool happened(semantics::Run& run, const MicroStepFacts* facts);
  bool holds(semantics::Run& run) const;
  bool has_left(const semantics::Run& run) const;

  Goal goal_;
  std::uint32_t activations_ = 0;  // of the state, when it was set
  std::uint32_t inner_ = 0;        // of the states within it
  bool active_ = false;            // whether the state or port was active then, or the condition fulfilled
  bool has_stopped_ = false;       // before the micro step that comes next
};

}  // namespace race::execution
