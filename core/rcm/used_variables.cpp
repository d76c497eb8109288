#include "core/rcm/used_variables.h"

#include "core/language/check/checker.h"

namespace race::rcm {

std::vector<std::string> used_variables(const State& state) {
  std::vector<std::string> names;
  const auto add = [&](const std::optional<std::string>& text) {
    if (!text) return;
    for (std::string& name : language::variable_names(*text)) names.push_back(std::move(name));
  };
  add(state.entry);
  add(state.exit);
  for (const Action& action : state.actions) {
    add(action.when);
    add(action.code);
  }
  for (const Port& port : state.ports) {
    add(port.when);
    add(port.after);
  }
  for (const Node& node : state.children)
    if (const auto* child = std::get_if<State>(&node))
      for (const Parameter& parameter : child->parameters) add(parameter.from);
  return names;
}

}  // namespace race::rcm
