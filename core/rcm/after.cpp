#include "core/rcm/after.h"

#include <algorithm>

namespace race::rcm {
namespace {

// A call that is lost with its timer, or with the server, is made again; while the timer is gone it fails at once.
constexpr int kMostTries = 10;
const std::string kWait = "svc." + std::string(kTimer) + ".wait";
// Of any other error, its code becomes the message of a fault: a time-out that never comes must not go unnoticed.
const std::string kFault = "int('time-out: ' + " + kWait + ".error.code)";

std::size_t waiting_ports(const State& state) {
  return static_cast<std::size_t>(
      std::ranges::count_if(state.ports, [](const Port& port) { return port.after.has_value(); }));
}

/// Where activation of the state leads without `after`: its first child, or the targets of its first barrier.
std::vector<std::string> first_states(const State& state) {
  if (!state.first) return {};
  for (const Node& child : state.children) {
    const auto* barrier = std::get_if<Barrier>(&child);
    if (barrier && barrier->name == *state.first) return barrier->to;
  }
  return {*state.first};
}

}  // namespace

std::string after_name(std::string_view port) { return "After_" + std::string(port); }

State after_state(const Port& port, DerivedIds& ids) {
  const auto meta = [&ids](const Meta& owner, std::string_view role) { return Meta{ids(owner.id, role), Value()}; };
  State out;
  out.name = after_name(port.name);
  out.meta = meta(port.meta, ":after");
  Parameter seconds;
  seconds.name = "seconds";
  seconds.from = port.after;
  seconds.unit = "s";
  seconds.meta = meta(out.meta, ":seconds");
  out.parameters.push_back(std::move(seconds));
  const std::string wait = kWait + "(par.seconds)", tries = std::to_string(kMostTries);
  out.variables.push_back(Datum{"tries", Value(1), Value(), "", "", meta(out.meta, ":tries")});
  out.entry = wait;
  out.actions.push_back(Action{kWait + ".error.code == 'unavailable' and var.tries < " + tries,
                               "var.tries += 1\n" + wait, meta(out.meta, ":again")});
  out.actions.push_back(Action{kWait + ".error.code != 'unavailable'", kFault, meta(out.meta, ":refused")});
  out.ports.push_back(Port{std::string(kDue), kWait + ".result", std::nullopt, std::nullopt, meta(out.meta, ":due")});
  return out;
}

bool has_after_barrier(const State& state) {
  const std::size_t waiting = waiting_ports(state);
  return waiting > 1 || (waiting == 1 && (state.first || state.oracle));
}

void translate_after(State& state, DerivedIds& ids) {
  if (waiting_ports(state) == 0) return;
  const bool has_barrier = has_after_barrier(state);
  std::vector<std::string> targets = first_states(state);
  for (Port& port : state.ports) {
    if (!port.after) continue;
    State wait = after_state(port, ids);
    targets.push_back(wait.name);
    port.when = "chi." + wait.name + ".port." + std::string(kDue);
    port.after.reset();
    state.children.emplace_back(std::move(wait));
  }
  if (has_barrier) {
    Meta meta{ids(state.meta.id, ":after"), Value()};
    state.children.emplace_back(Barrier{std::string(kAfterBarrier), targets, std::move(meta)});
    state.first = kAfterBarrier;
  } else {
    state.first = targets.front();
  }
}

}  // namespace race::rcm
