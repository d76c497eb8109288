// Goals as clients name them, found in a program.
#include <algorithm>
#include <utility>

#include "core/execution/goal.h"
#include "core/semantics/scope.h"

namespace race::execution {

using semantics::ActionId;
using semantics::Program;
using semantics::StateId;
using Kind = Goal::Kind;

namespace {

tl::unexpected<Error> not_found(const char* what, const GoalName& name) {
  const std::string field = name.id ? "id" : "path";
  return unexpected(ErrorCode::not_found, "there is no " + std::string(what) + " of this " + field, field);
}

/// The state in which the action stands.
StateId owner_of(const Program& program, ActionId action) {
  const auto owner = std::ranges::find_if(program.states, [&](const semantics::StateInfo& state) {
    return state.actions.low <= action && action < state.actions.high;
  });
  return StateId{static_cast<std::uint32_t>(owner - program.states.begin())};
}

/// Whether code within `state` calls it.
bool is_called(const Program& program, StateId state, const Goal& goal) {
  return std::ranges::any_of(program[state].calls, [&](semantics::OperationId o) {
    const auto& operation = program.services.operations()[o];
    return (goal.service.empty() || operation.open || operation.service == goal.service) &&
           (goal.operation.empty() || operation.name == goal.operation);
  });
}

Expected<void> find_port(const Program& program, const GoalName& name, Goal& goal) {
  const auto port = name.id ? program.port_with_id(*name.id) : program.find_port(name.path);
  if (!port) return not_found("port", name);
  goal.port = *port;
  goal.state = program[*port].state;
  return {};
}

Expected<void> find_state(const Program& program, const GoalName& name, Goal& goal) {
  const bool is_open = goal.kind == Kind::called || goal.kind == Kind::fault;
  if (is_open && !name.id && name.path.empty()) {
    goal.state = Program::root;
    return {};
  }
  const auto state = name.id ? program.state_with_id(*name.id) : program.find_state(name.path);
  if (!state) return not_found("state", name);
  goal.state = *state;
  return {};
}

Expected<void> find_action(const Program& program, const GoalName& name, Goal& goal) {
  if (const auto action = name.id ? program.ids.actions.find(*name.id) : std::nullopt) {
    goal.action = *action;
    goal.state = owner_of(program, *action);
    return {};
  }
  if (auto state = find_state(program, name, goal); !state) return not_found("state or action", name);
  if (program[goal.state].actions.size() == 0) return not_found("action", name);
  return {};
}

Expected<void> find_element(const Program& program, const GoalName& name, Goal& goal) {
  switch (goal.kind) {
    case Kind::micro:
    case Kind::macro:
      return {};
    case Kind::fired:
    case Kind::tested:
      return find_port(program, name, goal);
    case Kind::executed:
      return find_action(program, name, goal);
    default:
      return find_state(program, name, goal);
  }
}

}  // namespace

Expected<Goal> find_goal(const Program& program, const GoalName& name) {
  Goal goal{.kind = name.kind,
            .before = name.before || name.kind == Kind::fault,
            .service = name.service,
            .operation = name.operation};
  if (auto found = find_element(program, name, goal); !found) return tl::unexpected(std::move(found).error());
  if (goal.kind == Kind::called && !is_called(program, goal.state, goal))
    return unexpected(ErrorCode::not_found, "the state does not call this operation", "operation");
  if (name.condition.empty()) return goal;
  auto condition = compile_condition(program, goal.state, name.condition);
  if (!condition) {
    Error error = std::move(condition.error().front());
    error.path = "condition";
    return tl::unexpected(std::move(error));
  }
  goal.condition = std::move(*condition);
  return goal;
}

}  // namespace race::execution
