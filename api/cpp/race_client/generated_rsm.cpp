#include "api/cpp/race_client/generated_rsm.h"

#include <algorithm>
#include <utility>

namespace race::client {
namespace {

using Transitions = std::vector<rsm::Transition>;

// Of an operation that several states take.
std::string transition_id(const std::string& operation, const std::string& state) { return operation + "_" + state; }

rsm::Transition transition(std::string id, std::string src, std::string dst) {
  rsm::Transition made;
  made.id = std::move(id);
  made.src = std::move(src);
  made.dst = std::move(dst);
  return made;
}

void add_busy(const DeclaredOperation& operation, const Declaration& declaration, Transitions& transitions) {
  const std::string& name = operation.model.name;
  rsm::Transition begin = transition(name, kReady, operation.busy);
  begin.operation = name;
  begin.defer.push_back(name + "_done");
  for (const DeclaredOperation& each : declaration.operations)
    if (each.stops == operation.busy) begin.defer.push_back(transition_id(each.model.name, operation.busy));
  transitions.push_back(std::move(begin));
  transitions.push_back(transition(name + "_done", operation.busy, kReady));
}

void add_other(const DeclaredOperation& operation, const std::vector<rsm::ServiceState>& states,
               Transitions& transitions) {
  const std::string& name = operation.model.name;
  for (const rsm::ServiceState& state : states) {
    const bool ends = state.name == operation.stops;
    rsm::Transition taken = transition(transition_id(name, state.name), state.name, ends ? kReady : state.name);
    taken.operation = name;
    if (ends) taken.error = "stopped";
    transitions.push_back(std::move(taken));
  }
}

std::vector<rsm::ServiceState> states_of(const Declaration& declaration) {
  std::vector<std::string> events;
  for (const DeclaredEvent& each : declaration.events) events.push_back(each.model.name);
  std::vector<rsm::ServiceState> states;
  states.push_back({kReady, events});
  for (const DeclaredOperation& each : declaration.operations)
    if (!each.busy.empty() && std::ranges::find(states, each.busy, &rsm::ServiceState::name) == states.end())
      states.push_back({each.busy, events});
  return states;
}

}  // namespace

rsm::Service generated_rsm(const Declaration& declaration) {
  rsm::Service made;
  made.name = declaration.key;
  made.init = kReady;
  made.states = states_of(declaration);
  for (const DeclaredEvent& each : declaration.events) made.events.push_back(each.model);
  for (const DeclaredOperation& each : declaration.operations) {
    made.operations.push_back(each.model);
    if (each.busy.empty())
      add_other(each, made.states, made.transitions);
    else
      add_busy(each, declaration, made.transitions);
  }
  if (!declaration.version.empty()) made.meta = Dict{{"version", declaration.version}};
  return made;
}

}  // namespace race::client
