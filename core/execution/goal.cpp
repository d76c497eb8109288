#include "core/execution/goal.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/semantics/scope.h"

namespace race::execution {

using language::Truth;
using semantics::ActionId;
using semantics::Program;
using semantics::Run;
using semantics::StateId;
using Kind = Goal::Kind;

std::string_view name(Goal::Kind kind) {
  static constexpr std::array kNames = {"micro",  "macro",    "entered", "left",  "into",     "fired",
                                        "tested", "executed", "called",  "fault", "fulfilled"};
  return kNames[static_cast<std::size_t>(kind)];
}

bool Goal::operator==(const Goal& other) const {
  const auto text = [](const semantics::Code& code) { return code ? code.text() : std::string(); };
  return kind == other.kind && before == other.before && state == other.state && port == other.port &&
         action == other.action && service == other.service && operation == other.operation &&
         text(condition) == text(other.condition);
}

namespace {

std::uint32_t activations_within(const Run& run, StateId state) {
  std::uint32_t sum = 0;
  for (std::uint32_t s = index(state) + 1; s < run.program()[state].end; ++s) sum += run.state().live[s].activations;
  return sum;
}

}  // namespace

bool GoalWatch::holds(Run& run) const {
  return !goal_.condition || run.truth(goal_.condition, goal_.state) == Truth::yes;
}

void GoalWatch::set(Run& run) {
  if (goal_.state != semantics::kNoState) {
    activations_ = run.state().live[index(goal_.state)].activations;
    active_ = run.is_active(goal_.state);
  }
  if (goal_.kind == Kind::into) inner_ = activations_within(run, goal_.state);
  if (goal_.port != semantics::kNoPort) active_ = run.state().flags[run.program().flag(goal_.port)] != 0;
  if (goal_.kind == Kind::fulfilled) active_ = active_ && holds(run);
}

bool GoalWatch::carry_over(const semantics::Correspondence& same, const Program& program) {
  const auto carry = [](auto& id, const std::vector<std::uint32_t>& before, auto none) {
    if (id == none) return true;
    const auto found = std::ranges::find(before, static_cast<std::uint32_t>(id));
    if (found == before.end()) return false;
    id = std::remove_reference_t<decltype(id)>{static_cast<std::uint32_t>(found - before.begin())};
    return true;
  };
  if (!carry(goal_.state, same.states, semantics::kNoState) || !carry(goal_.port, same.ports, semantics::kNoPort) ||
      !carry(goal_.action, same.actions, semantics::kNone))
    return false;
  if (!goal_.condition) return true;
  auto condition = compile_condition(program, goal_.state, goal_.condition.text());
  if (condition) goal_.condition = *condition;
  return condition.has_value();
}

// Activations that could have ended since it was set, the one that was under way included.
bool GoalWatch::has_left(const Run& run) const {
  const std::uint32_t begun = run.state().live[index(goal_.state)].activations - activations_ + (active_ ? 1U : 0U);
  return begun >= 2 || (begun == 1 && !run.is_active(goal_.state));
}

bool GoalWatch::happened(Run& run, const MicroStepFacts* facts) {
  const auto is_within = [&](StateId s) {
    return index(s) >= index(goal_.state) && index(s) < run.program()[goal_.state].end;
  };
  switch (goal_.kind) {
    case Kind::micro:
      return !facts || facts->changed;
    case Kind::macro:
      return false;  // no micro step reaches it: the end of the macro step does
    case Kind::entered:
      return run.state().live[index(goal_.state)].activations != activations_;
    case Kind::left:
      return has_left(run);
    case Kind::into:
      return activations_within(run, goal_.state) != inner_ || has_left(run);
    case Kind::fired: {
      const bool before = std::exchange(active_, run.state().flags[run.program().flag(goal_.port)] != 0);
      return active_ && !before;
    }
    case Kind::tested:
      return std::ranges::find(facts->tested, goal_.port) != facts->tested.end();
    case Kind::executed:
      return std::ranges::any_of(facts->nodes, [&](const semantics::DerivationNode& node) {
        if (node.rule != semantics::Rule::Action1 || node.at != run.program().flag(goal_.state)) return false;
        return goal_.action == semantics::kNone || run.program()[goal_.state].actions.low + node.action == goal_.action;
      });
    case Kind::called:
      return std::ranges::any_of(facts->calls, [&](const semantics::OutgoingCall& call) {
        return (goal_.service.empty() || call.service == goal_.service) &&
               (goal_.operation.empty() || call.name == goal_.operation) && is_within(call.caller);
      });
    case Kind::fault: {
      if (!run.fault() || run.is_told_to_stop()) return false;
      const std::string& within = run.program()[goal_.state].path;
      return run.fault()->at == within || run.fault()->at.starts_with(within + "/");
    }
    case Kind::fulfilled: {
      const bool before = std::exchange(active_, run.is_active(goal_.state) && holds(run));
      return active_ && !before;
    }
  }
  return false;
}

bool GoalWatch::reached(Run& run, const MicroStepFacts* facts) {
  has_stopped_ = false;
  const bool reached = happened(run, facts);
  if (reached) set(run);
  return reached && !goal_.before && holds(run);
}

bool GoalWatch::stops_before(Run& run, Run& ahead, const MicroStepFacts& facts) {
  if (!goal_.before || has_stopped_) return false;
  GoalWatch in_future = *this;
  // What has to hold before the micro step does not hold there yet if it is this that is waited for.
  has_stopped_ = in_future.happened(ahead, &facts) && (goal_.kind == Kind::fulfilled || holds(run));
  return has_stopped_;
}

}  // namespace race::execution
