#include "core/execution/goal.h"

#include <array>
#include <utility>

namespace race::execution {

using semantics::Program;
using semantics::Run;

std::string_view name(Goal::Kind kind) {
  static constexpr std::array kNames = {"micro", "macro", "entered", "left", "fired"};
  return kNames[static_cast<std::size_t>(kind)];
}

namespace {

tl::unexpected<Error> not_found(const char* what, const GoalName& name) {
  const std::string by = name.id ? "id" : "path";
  return unexpected(ErrorCode::not_found, "there is no " + std::string(what) + " of this " + by,
                    name.id.value_or(name.path));
}

}  // namespace

Expected<Goal> find_goal(const Program& program, const GoalName& name) {
  Goal goal{.kind = name.kind};
  if (name.kind == Goal::Kind::entered || name.kind == Goal::Kind::left) {
    const auto state = name.id ? program.state_with_id(*name.id) : program.find_state(name.path);
    if (!state) return not_found("state", name);
    goal.state = *state;
  }
  if (name.kind == Goal::Kind::fired) {
    const auto port = name.id ? program.port_with_id(*name.id) : program.find_port(name.path);
    if (!port) return not_found("port", name);
    goal.port = *port;
  }
  return goal;
}

void GoalWatch::set(const Run& run) {
  if (goal_.state != semantics::kNoState) {
    activations_ = run.state().live[index(goal_.state)].activations;
    active_ = run.is_active(goal_.state);
  }
  if (goal_.port != semantics::kNoPort) active_ = run.state().flags[run.program().flag(goal_.port)] != 0;
}

bool GoalWatch::carry_over(const semantics::Correspondence& same) {
  const auto carry = [](auto& id, const std::vector<std::uint32_t>& before, auto none) {
    if (id == none) return true;
    const auto found = std::ranges::find(before, index(id));
    if (found == before.end()) return false;
    id = std::remove_reference_t<decltype(id)>{static_cast<std::uint32_t>(found - before.begin())};
    return true;
  };
  return carry(goal_.state, same.states, semantics::kNoState) && carry(goal_.port, same.ports, semantics::kNoPort);
}

bool GoalWatch::reached(const Run& run) {
  bool reached = false;
  switch (goal_.kind) {
    case Goal::Kind::micro:
      return true;
    case Goal::Kind::macro:
      return false;  // no micro step reaches it: the end of the macro step does
    case Goal::Kind::entered:
      reached = run.state().live[index(goal_.state)].activations != activations_;
      break;
    case Goal::Kind::left: {
      // Activations that could have ended since then, the one that was under way included.
      const std::uint32_t begun = run.state().live[index(goal_.state)].activations - activations_ + (active_ ? 1U : 0U);
      reached = begun >= 2 || (begun == 1 && !run.is_active(goal_.state));
      break;
    }
    case Goal::Kind::fired: {
      const bool before = std::exchange(active_, run.state().flags[run.program().flag(goal_.port)] != 0);
      return active_ && !before;
    }
  }
  if (reached) set(run);
  return reached;
}

}  // namespace race::execution
