// Random models and random inputs for them, from a seed. The models are legal documents of every construct: nesting,
// barriers, forks and joins, loops, keep, parameters, actions with and without service data, calls, unmet and faulty
// code.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "core/rsm/model.h"
#include "core/semantics/run.h"

namespace race::semantics {

class RandomModels {
 public:
  explicit RandomModels(std::uint64_t seed) : random_(seed) {}

  /// A native model with at most about 40 states.
  rcm::NativeModel model() {
    states_ = 0;
    return {state("Root", 0, {}), {}};
  }

  /// Service `t`: events e0..e3 and the sampled s0, operations o0, o1; `safe` is declared safe.
  static std::map<std::string, rsm::Service> services() {
    rsm::Service service;
    service.name = "t";
    for (const char* name : {"e0", "e1", "e2", "e3", "s0"}) {
      rsm::Event event;
      event.name = name;
      event.sampled = event.name == "s0";
      service.events.push_back(event);
    }
    for (const char* name : {"o0", "o1", "halt"}) {
      rsm::Operation operation;
      operation.name = name;
      operation.safe = operation.name == "halt";
      service.operations.push_back(operation);
    }
    return {{"t", service}};
  }

  /// What arrives next at every one of `runs`, which are in the same state: an occurrence, or a response to a recent
  /// call.
  void post(const std::vector<Run*>& runs, std::uint64_t calls) {
    if (calls > 0 && chance(0.4)) {
      const std::uint64_t number = calls - std::min<std::uint64_t>(pick(4), calls - 1);
      const bool error = chance(0.3);
      const Value data = error ? Value(Dict{{"code", "no"}}) : value();
      for (Run* run : runs) run->post_response(number, error, data);
      return;
    }
    static const char* const kEvents[] = {"e0", "e1", "e2", "e3", "s0"};
    const char* const event = kEvents[pick(5)];
    const Value data = chance(0.8) ? Value(Dict{{"x", value()}}) : Value();
    for (Run* run : runs) run->post_event("t", event, data);
  }

  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(random_) < p; }

 private:
  struct Names {  // of the surroundings, for code
    std::vector<std::string> parameters, results;
  };

  Value value() { return Value(static_cast<std::int64_t>(pick(5)) - 1); }
  std::string number(std::size_t n) { return std::to_string(pick(n)); }

  std::string service_datum() {
    switch (pick(8)) {
      case 0:
        return "svc.t.e" + number(4);
      case 1:
        return "svc.t.e" + number(4) + ".x > " + number(3);
      case 2:
        return "svc.t.o" + number(2) + ".result";
      case 3:
        return "svc.t.o" + number(2) + ".error";
      case 4:
        return "svc.t.s0.x >= " + number(4);
      case 5:
        return "svc.t.s0";
      case 6:
        return "svc.t.e" + number(4) + ".latest.x == " + number(3);
      default:
        return "not available(svc.t.e" + number(4) + ")";
    }
  }

  std::string atom(const rcm::State& s) {
    if (chance(0.45)) return service_datum();
    if (!s.children.empty() && chance(0.5)) {
      const rcm::Node& child = s.children[pick(s.children.size())];
      const std::string chi = "chi." + rcm::name_of(child);
      if (std::holds_alternative<rcm::Barrier>(child)) return chi + ".active";
      const auto& c = std::get<rcm::State>(child);
      if (!c.ports.empty() && chance(0.5)) return chi + ".port." + c.ports[pick(c.ports.size())].name;
      if (chance(0.4)) return chi + ".res.r > " + number(3);
      return chi + ".active";
    }
    switch (pick(4)) {
      case 0:
        return "res.r == " + number(4);
      case 1:
        return "var.v > " + number(3);
      case 2:
        return "available(res.r)";
      default:
        return "par.p < " + number(3);
    }
  }

  std::string condition(const rcm::State& s) {
    switch (pick(6)) {
      case 0:
        return atom(s) + " and " + atom(s);
      case 1:
        return atom(s) + " or " + atom(s);
      case 2:
        return "not (" + atom(s) + ")";
      default:
        return atom(s);
    }
  }

  std::string function() {
    switch (pick(9)) {
      case 0:
        return "svc.t.o" + number(2) + "(par.p)";
      case 1:
        return "res.r = " + number(4) + "\nsvc.t.o" + number(2) + "(res.r, k=1)";
      case 2:
        return "res.r = svc.t.e" + number(4) + ".x";
      case 3:
        return "var.v = var.v + 1";
      case 4:
        return "if par.p > 1:\n    res.r = 0\nelse:\n    var.v = 2";
      case 5:
        return "var.v = (var.v + 1) % 4\nres.r = var.v";
      case 6:
        return "res.r = svc.t.s0.latest.x";
      case 7:
        return faults_ && chance(0.1) ? "res.r = 1 // (par.p - par.p)" : "res.r = 1";
      default:
        return "res.r = par.p";
    }
  }

  rcm::State state(const std::string& name, int depth, const std::vector<std::string>& siblings) {
    ++states_;
    rcm::State s;
    s.name = name;
    rcm::Parameter p;
    p.name = "p";
    if (depth > 0 && chance(0.5))
      p.from = chance(0.8) ? "par.p" : "var.v";
    else
      p.value = value();
    s.parameters.push_back(p);
    rcm::Datum r;
    r.name = "r";
    if (chance(0.5)) r.initial = value();
    s.results.push_back(r);
    rcm::Datum v;
    v.name = "v";
    v.initial = Value(0);
    s.variables.push_back(v);

    std::vector<std::string> names, barriers;
    if (depth < 4 && states_ < 40 && chance(depth == 0 ? 1.0 : 0.5)) {
      const std::size_t count = 1 + pick(4);
      for (std::size_t i = 0; i < count; ++i) names.push_back("S" + std::to_string(i));
      for (std::size_t i = 0; i < pick(3); ++i) barriers.push_back("b" + std::to_string(i));
    }
    std::vector<std::string> targets = names;
    targets.insert(targets.end(), barriers.begin(), barriers.end());
    for (const std::string& child : names) s.children.emplace_back(state(child, depth + 1, targets));
    for (const std::string& barrier : barriers) {
      rcm::Barrier b;
      b.name = barrier;
      for (const std::string& child : names)
        if (chance(0.6)) b.to.push_back(child);
      s.children.emplace_back(std::move(b));
    }
    if (!targets.empty() && chance(0.9)) s.first = targets[pick(targets.size())];

    const std::size_t ports = depth == 0 ? pick(2) : pick(4);
    for (std::size_t i = 0; i < ports; ++i) {
      rcm::Port port;
      port.name = "p" + std::to_string(i);
      s.ports.push_back(port);
    }
    for (rcm::Port& port : s.ports) {
      port.when = condition(s);
      if (depth == 0) port.when = "(" + *port.when + ") and svc.t.e3.x > 2";  // most runs go on for long
      if (!siblings.empty() && chance(0.85)) port.to = siblings[pick(siblings.size())];
    }
    for (std::size_t i = 0; i < pick(3); ++i) {
      rcm::Action action;
      action.when = chance(0.2) ? "True" : condition(s);
      action.code = function();
      s.actions.push_back(action);
    }
    if (chance(0.3)) s.entry = chance(0.5) ? "res.r = par.p" : "svc.t.o" + number(2) + "()";
    if (chance(0.2)) s.exit = "var.v = 1";
    if (!s.ports.empty() && chance(0.2)) {
      s.keep.emplace();
      s.keep->any = chance(0.5);
      if (!s.keep->any) s.keep->ports.push_back(s.ports[pick(s.ports.size())].name);
    }
    return s;
  }

  std::mt19937_64 random_;
  int states_ = 0;
  bool faults_ = true;
};

}  // namespace race::semantics
