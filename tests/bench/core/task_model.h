// A document as people write them, of any size: up to five levels of states, each with parameters, results, a variable,
// functions, actions and ports whose conditions read services; some steps link a state of the library. It has ids, a
// place of every state in `layout`, and no violations.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "core/rcm/ids.h"
#include "core/rcm/model.h"

namespace race::bench {

/// How much a state has: `heavy`, 2.8 kB of text, one in ten a link; `usual`, about half as much, about half of them
/// links (those of the demonstrator have 1 kB and are about half links).
enum class Density { heavy, usual };

/// Whether the step `number`, which has no children, is a link.
inline bool is_link(int number, Density density) {
  return density == Density::heavy ? number % 10 == 0 : number % 3 != 0;
}

/// What every state has; `number` is in its code, so that no two have the same. `linked`: without behaviour of its own.
inline rcm::State step(const std::string& name, const std::optional<std::string>& next, int number, bool linked,
                       Density density) {
  const std::string text = std::to_string(number);
  rcm::State out;
  out.name = name;
  out.parameters = {
      {"target", {}, "par.target", "pose", "", "Where the tool goes, in o", {}},
      {"speed", {}, "min(par.speed, 0.5) * 0." + text, "number", "", "Of the robot, relative to its limits", {}},
      {"force", Value(20.0), {}, "number", "N", "", {}},
  };
  out.ports = {
      {"success", "svc.robot.move_cartesian.result and available(res.held) and par.force < " + text, {}, next, {}},
      {"retry", "svc.robot.move_cartesian.error and var.tries < " + text, {}, name, {}},
      {"error",
       "svc.robot.move_cartesian.error.code == 'collision' or svc.gripper.grasp.error.x == " + text,
       {},
       {},
       {}},
  };
  if (density == Density::usual) {
    out.parameters.resize(2);
    out.parameters[0].doc.clear();
    out.ports.erase(out.ports.begin() + 1);
    out.ports[0].when = "available(res.held) and par.speed < " + text;
  }
  if (linked) {
    for (rcm::Port& port : out.ports) port.when.reset();
    out.link = "Step" + std::to_string(number / 10 % 5);
    return out;
  }
  out.doc = "Moves the tool to the target, closes the gripper on what is there and says what it holds.";
  out.results = {{"held", {}, "bool", "", "Whether the gripper holds something", {}}};
  if (density == Density::usual) {
    out.entry = "svc.gripper.grasp(0.02, par.speed, force=" + text + ")\n";
    out.actions = {{"svc.gripper.grasp.result", "res.held = svc.gripper.grasp.result.held == " + text, {}}};
    return out;
  }
  out.variables = {{"tries", Value(0), "int", "", "", {}}};
  out.entry = "var.tries += " + text +
              "\n"
              "if par.speed > 0.2:\n"
              "    svc.robot.move_cartesian([par.target], speed=par.speed, force=par.force)\n"
              "else:\n"
              "    svc.gripper.grasp(0.02, par.speed, force=min(par.force, 80))\n";
  out.actions = {{"svc.gripper.grasp.result", "res.held = svc.gripper.grasp.result.held == " + text, {}}};
  return out;
}

/// Adds states below `parent`, `left` in all, five to a parent.
inline void fill(rcm::State& parent, int depth, int share, int& made, Density density) {
  int left = share;
  for (int i = 0; i < 5 && left > 0; ++i) {
    const int part = depth == 1 ? 1 : std::max(1, share / 5 + (i < share % 5 ? 1 : 0));
    const bool is_last = i == 4 || left <= part;
    const std::string next = is_last ? "Joined" : "S" + std::to_string(i + 1);
    ++made;
    rcm::State child = step("S" + std::to_string(i), next, made, part == 1 && is_link(made, density), density);
    if (part > 1) fill(child, depth - 1, part - 1, made, density);
    parent.children.emplace_back(std::move(child));
    left -= part;
  }
  parent.children.emplace_back(rcm::Barrier{"Joined", {"S0"}, {}});
  parent.first = "S0";
  parent.ports[0].when = "chi.Joined.active and chi.S0.port.success and chi.S0.par.speed > 0." + std::to_string(made);
}

inline void place(const rcm::State& state, Dict& layout) {
  layout.set(state.meta.id, Dict{{"x", 120.5}, {"y", 64.0}});
  for (const rcm::Node& node : state.children) {
    if (const auto* child = std::get_if<rcm::State>(&node)) place(*child, layout);
  }
}

/// A task of about `count` states.
inline rcm::Document task_document(int count, Density density) {
  rcm::Document out;
  out.name = "task";
  out.services = {{"display", "display"}, {"gripper", "gripper"}, {"robot", "robot"}};
  for (int i = 0; i < 5; ++i) out.library.push_back(step("Step" + std::to_string(i), {}, i, false, density));
  for (rcm::State& state : out.library) state.ports[1].to.reset();
  out.root = step("Task", {}, 5, false, density);
  for (rcm::Parameter& parameter : out.root.parameters) parameter.from.reset();
  out.root.parameters[1].value = Value(0.3);
  out.root.ports[1].to.reset();
  int made = 5;
  fill(out.root, 4, count - 6, made, density);
  rcm::give_ids(out);
  Dict layout;
  place(out.root, layout);
  out.layout = std::move(layout);
  return out;
}

}  // namespace race::bench
