// The workloads of the benchmark, built as models: one event of service `t` with a payload {"x": n} drives each of
// them.
#pragma once

#include <string>

#include "core/rcm/model.h"

namespace race::bench {

inline rcm::Port port(std::string name, std::string when, std::optional<std::string> to) {
  rcm::Port p;
  p.name = std::move(name);
  p.when = std::move(when);
  p.to = std::move(to);
  return p;
}

inline rcm::State state(std::string name) {
  rcm::State s;
  s.name = std::move(name);
  return s;
}

inline const char* const kGuard = "svc.t.ev.x > 0";

/// `count` siblings in a ring; each event passes one on. Two of them toggle.
inline rcm::State ring(int count) {
  rcm::State root = state("Root");
  for (int i = 0; i < count; ++i) {
    rcm::State child = state("S" + std::to_string(i));
    child.ports.push_back(port("p", kGuard, "S" + std::to_string((i + 1) % count)));
    root.children.emplace_back(std::move(child));
  }
  root.first = "S0";
  return root;
}

/// Toggling under `depth` ancestors, each with a port whose condition reads the same payload and is false.
inline rcm::State deep(int depth) {
  rcm::State inner = ring(2);
  inner.name = "Leaf";
  for (int i = depth; i-- > 0;) {
    inner.ports.push_back(port("never", "svc.t.ev.x < 0", std::nullopt));
    rcm::State outer = state(i == 0 ? "Root" : "Level" + std::to_string(i));
    outer.first = inner.name;
    outer.children.emplace_back(std::move(inner));
    inner = std::move(outer);
  }
  return inner;
}

/// `count` children behind a barrier: each event takes all of them to it, which lets all of them start again.
inline rcm::State concurrent(int count) {
  rcm::State root = state("Root");
  rcm::Barrier barrier;
  barrier.name = "all";
  for (int i = 0; i < count; ++i) {
    rcm::State child = state("C" + std::to_string(i));
    child.ports.push_back(port("p", kGuard, "all"));
    barrier.to.push_back(child.name);
    root.children.emplace_back(std::move(child));
  }
  root.children.emplace_back(std::move(barrier));
  root.first = "all";
  return root;
}

/// An action that adds the payload, and a port on the sum.
inline rcm::State sum() {
  rcm::State root = state("Root");
  rcm::Datum result;
  result.name = "sum";
  result.initial = Value(0);
  root.results.push_back(result);
  rcm::Action action;
  action.when = "svc.t.ev";
  action.code = "res.sum = res.sum + svc.t.ev.x";
  root.actions.push_back(action);
  root.ports.push_back(port("full", "res.sum < 0", std::nullopt));
  return root;
}

}  // namespace race::bench
