#include "server/model_tests/coverage.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace race::server {

using semantics::PortId;
using semantics::Program;
using semantics::StateId;

namespace {

// The place in the document; empty: none.
std::string place_of(const std::string& path, const Coverage::Origin& origin, const std::string& library) {
  const auto found = origin.find(path);
  if (found == origin.end()) return "";
  const std::string& place = found->second;
  const bool below = !library.empty() && place.starts_with(library) &&
                     (place.size() == library.size() || place[library.size()] == '/' || place[library.size()] == '.');
  return below ? "library/" + place : place;
}

// Of a port that translation has made there is none: its origin is a state.
std::string place_of_port(const Program& program, PortId port, const Coverage::Origin& origin,
                          const std::string& library) {
  std::string place = place_of(program.address(port), origin, library);
  return place.ends_with("." + program[port].name) ? place : "";
}

// What a port with a time-out is made into comes from that port: no state of the document.
std::string place_of_state(const Program& program, StateId state, const Coverage::Origin& origin,
                           const std::string& library) {
  std::string place = place_of(program[state].path, origin, library);
  const std::size_t dot = place.rfind('.');
  const bool is_port = dot != std::string::npos && place.find('/', dot) == std::string::npos;
  return is_port ? "" : place;
}

Coverage::Count count(const std::map<std::string, bool>& elements) {
  const auto covered = std::ranges::count_if(elements, [](const auto& entry) { return entry.second; });
  return {static_cast<std::size_t>(covered), elements.size()};
}

Dict json_of(const Coverage::Count& count, List reached, List missing) {
  return Dict{{"covered", static_cast<std::int64_t>(count.covered)},
              {"all", static_cast<std::int64_t>(count.all)},
              {"reached", std::move(reached)},
              {"missing", std::move(missing)}};
}

// Those that are covered, or are not.
List places(const std::map<std::string, bool>& elements, bool are_covered) {
  List out;
  for (const auto& [place, covered] : elements)
    if (covered == are_covered) out.emplace_back(place);
  return out;
}

Value json_of(const Coverage::ConditionPlace& place, bool value) {
  Dict json{{"at", place.at}};
  if (place.action > 0) json.set("action", static_cast<std::int64_t>(place.action));
  json.set("value", value);
  return json;
}

}  // namespace

void Coverage::add(const Program& program, const Origin& origin, const std::string& library) {
  CoverageOfRun(*this, program, origin, library);
}

Coverage::Count Coverage::states() const { return count(states_); }

Coverage::Count Coverage::ports() const { return count(ports_); }

Coverage::Count Coverage::conditions() const {
  Count out{0, 2 * conditions_.size()};
  for (const auto& [place, condition] : conditions_)
    out.covered += (condition.held ? 1U : 0U) + (condition.failed ? 1U : 0U);
  return out;
}

Value Coverage::json() const {
  List reached, missing;
  for (const auto& [place, condition] : conditions_)
    for (const bool value : {true, false})
      ((value ? condition.held : condition.failed) ? reached : missing).push_back(json_of(place, value));
  return Dict{{"states", json_of(states(), places(states_, true), places(states_, false))},
              {"ports", json_of(ports(), places(ports_, true), places(ports_, false))},
              {"conditions", json_of(conditions(), std::move(reached), std::move(missing))}};
}

CoverageOfRun::CoverageOfRun(Coverage& coverage, const Program& program, const Coverage::Origin& origin,
                             const std::string& library)
    : states_(program.states.size()),
      ports_(program.ports.size()),
      port_conditions_(program.ports.size()),
      action_conditions_(program.actions.size()) {
  for (std::uint32_t i = 0; i < program.states.size(); ++i) {
    const semantics::StateInfo& state = program.states[i];
    const std::string place = place_of_state(program, StateId{i}, origin, library);
    if (place.empty()) continue;
    states_[i] = &coverage.states_[place];
    for (std::uint32_t a = state.actions.low; a < state.actions.high; ++a)
      action_conditions_[a] = &coverage.conditions_[Coverage::ConditionPlace{place, a - state.actions.low + 1}];
  }
  for (std::uint32_t i = 0; i < program.ports.size(); ++i) {
    const std::string place = place_of_port(program, PortId{i}, origin, library);
    if (place.empty()) continue;
    ports_[i] = &coverage.ports_[place];
    if (program.ports[i].when) port_conditions_[i] = &coverage.conditions_[Coverage::ConditionPlace{place, 0}];
  }
}

// A copy of the run evaluates the conditions, and only if one is left of which not both values were seen.
void CoverageOfRun::look(const execution::Execution& execution) {
  const Program& program = execution.run().program();
  std::optional<semantics::Run> copy;
  const auto see = [&](Coverage::Condition* condition, const semantics::Code& code, StateId state) {
    if (!condition || !code || (condition->held && condition->failed)) return;
    if (!copy) copy.emplace(execution.run());
    const language::Truth truth = copy->truth(code, state);
    if (truth == language::Truth::yes) condition->held = true;
    if (truth == language::Truth::no || truth == language::Truth::unknown) condition->failed = true;
  };
  for (std::uint32_t i = 0; i < program.states.size(); ++i) {
    const StateId state{i};
    if (!execution.run().is_active(state)) continue;
    if (states_[i]) *states_[i] = true;
    const semantics::StateInfo& info = program[state];
    for (std::uint32_t p = info.ports.low; p < info.ports.high; ++p)
      see(port_conditions_[p], program.ports[p].when, state);
    for (std::uint32_t a = info.actions.low; a < info.actions.high; ++a)
      see(action_conditions_[a], program.actions[a].when, state);
  }
}

void CoverageOfRun::fired(const Program& program, const std::string& port) {
  const auto found = program.find_port(port);
  if (!found) return;
  if (bool* covered = ports_[semantics::index(*found)]) *covered = true;
  if (Coverage::Condition* condition = port_conditions_[semantics::index(*found)]) condition->held = true;
}

}  // namespace race::server
