// Random models and random inputs for them, from a seed. The models are legal documents of every construct: nesting,
// barriers, forks and joins, loops, keep, parameters, actions with and without service data, calls, services named
// dynamically, unmet and faulty code.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/rcm/model.h"
#include "core/rsm/model.h"
#include "core/semantics/budgets.h"

namespace race::semantics {

class RandomModels {
 public:
  /// `data`: functions also make strings and lists.
  explicit RandomModels(std::uint64_t seed, bool data = true) : random_(seed), data_(data) {}

  /// A native model with at most about 40 states; one in five is deep and narrow.
  rcm::NativeModel model() {
    states_ = 0;
    deep_ = chance(0.2);
    return {state("Root", 0, {}), {}};
  }

  /// Budgets of a run; every third has so little that runs meet one now and then.
  static Budgets budgets(std::uint64_t seed) {
    Budgets budgets;
    budgets.micro_steps = 300;
    if (seed % 3 != 0) return budgets;
    budgets.work = 100 + seed % 400;
    budgets.calls = 1 + seed % 7;
    budgets.output_units = 5 + seed % 50;
    budgets.data_units = 10 + seed % 90;
    return budgets;
  }

  /// Services `t` and `u`, alike: events e0..e3 and the sampled s0, operations o0, o1 and `halt`, which is safe.
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
    return {{"t", service}, {"u", service}};
  }

  /// What arrives next at every one of `runs`, which are in the same state: an occurrence, a response to a recent call,
  /// or the loss of a service. They are what has post_event, post_response and post_lost.
  template <typename R>
  void post(const std::vector<R*>& runs, std::uint64_t calls) {
    if (chance(0.02)) {
      const std::string lost = chance(0.2) ? "v" : service();
      for (R* run : runs) run->post_lost(lost);
      return;
    }
    if (calls > 0 && chance(0.4)) {
      const std::uint64_t number = calls - std::min<std::uint64_t>(pick(4), calls - 1);
      const bool error = chance(0.3);
      const Value data = error ? Value(Dict{{"code", "no"}}) : value();
      for (R* run : runs) run->post_response(number, error, data);
      return;
    }
    static const char* const kEvents[] = {"e0", "e1", "e2", "e3", "s0"};
    const char* const event = kEvents[pick(5)];
    const std::string of = service();
    const Value data = Value(Dict{{"x", value()}});
    for (R* run : runs) run->post_event(of, event, data);
  }

  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(random_) < p; }

 private:
  Value value() { return Value(static_cast<std::int64_t>(pick(5)) - 1); }
  std::string number(std::size_t n) { return std::to_string(pick(n)); }

  std::string service() { return chance(0.8) ? "t" : "u"; }

  // A service by its name, or by a computed one.
  std::string svc() {
    if (chance(0.8)) return "svc." + service();
    if (chance(0.5)) return "svc['" + service() + "']";
    if (chance(0.3)) return "svc['v' if var.v > 1 else 'w']";  // services that nobody declares
    return chance(0.5) ? "svc['t' if par.p > 1 else 'u']" : "svc['u' if var.v > 1 else 't']";
  }

  std::string service_datum() {
    switch (pick(10)) {
      case 0:
        return svc() + ".e" + number(4);
      case 1:
        return svc() + ".e" + number(4) + ".x > " + number(3);
      case 2:
        return svc() + ".o" + number(2) + ".result";
      case 3:
        return svc() + ".o" + number(2) + ".error";
      case 4:
        return svc() + ".s0.x >= " + number(4);
      case 5:
        return svc() + ".s0";
      case 6:
        return svc() + ".e" + number(4) + ".latest.x == " + number(3);
      case 7:
        return svc() + ".o" + number(2) + ".result == " + number(4);
      case 8:
        return "available(" + svc() + ".o" + number(2) + ".result) or available(" + svc() + ".o" + number(2) +
               ".error)";
      default:
        return "not available(" + svc() + ".e" + number(4) + ")";
    }
  }

  std::string child_atom(const rcm::Node& child) {
    const std::string chi = "chi." + rcm::name_of(child);
    if (std::holds_alternative<rcm::Barrier>(child)) return chance(0.5) ? chi : chi + ".active";
    const auto& c = std::get<rcm::State>(child);
    if (!c.ports.empty() && chance(0.4)) return chi + ".port." + c.ports[pick(c.ports.size())].name;
    switch (pick(6)) {
      case 0:
        return chi + ".res.r > " + number(3);
      case 1:
        return chi + ".par.p == " + number(3);
      case 2:
        return "available(" + chi + ".res.r)";
      case 3:
        return chi;
      default:
        return chi + ".active";
    }
  }

  std::string atom(const rcm::State& s) {
    if (chance(0.45)) return service_datum();
    if (!s.children.empty() && chance(0.5)) return child_atom(s.children[pick(s.children.size())]);
    switch (pick(9)) {
      case 0:
        return "res.r == " + number(4);
      case 1:
        return "var.v > " + number(3);
      case 2:
        return "available(res.r)";
      case 3:
        return "'r' in res";
      case 4:
        return "var.get('w', 0) > " + number(3);
      case 5:
        return "len(par) + sum(var.values()) > " + number(4);
      case 6:
        return s.ports.empty() ? "var.w > 0" : "not port." + s.ports[pick(s.ports.size())].name + " and var.v > 0";
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
    switch (pick(data_ ? 15 : 13)) {
      case 0:
        return svc() + ".o" + number(2) + "(par.p)";
      case 1:
        return "res.r = " + number(4) + "\n" + svc() + ".o" + number(2) + "(res.r, k=1)";
      case 2:
        return "res.r = " + svc() + ".e" + number(4) + ".x";
      case 3:
        return "var.v = var.v + 1";
      case 4:
        return "if par.p > 1:\n    res.r = 0\nelse:\n    var.v = 2";
      case 5:
        return "var.v = (var.v + 1) % 4\nres.r = var.v";
      case 6:
        return "res.r = " + svc() + ".s0.latest.x";
      case 7:
        return chance(0.1) ? "res.r = 1 // (par.p - par.p)" : "res.r = 1";
      case 8:
        return "var.w = len(res) + " + number(3);
      case 9:
        return "if available(" + svc() + ".o" + number(2) + ".error):\n    var.v = 0\nelse:\n    var.w = 2";
      case 10:  // unmet once it has called
        return "var.v = 3\n" + svc() + ".o0(1)\nres.r = " + svc() + ".o0.result";
      case 11:
        return "for i in range(par.p):\n    " + svc() + ".o" + number(2) + "(i)\nvar.v = 1";
      case 13:  // data that grows, shared by several places
        return "l = var.l if available(var.l) else []\nm = l\nl.append([var.v])\nvar.l = l\nm.append(len(l))\nvar.m = "
               "m";
      case 14:
        return "print(list(range(par.p)))\nvar.l = [var.l, 'ab'] if available(var.l) else 'abc'";
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
      p.from = chance(0.7) ? "par.p" : chance(0.5) ? "var.v" : "par.p if len(var) > 1 else sum(par.values())";
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
    if (depth < (deep_ ? 12 : 4) && states_ < 40 && chance(depth == 0 ? 1.0 : deep_ ? 0.9 : 0.5)) {
      const std::size_t count = deep_ ? 1 + pick(2) : 1 + pick(4);
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
    if (chance(0.3)) s.entry = chance(0.5) ? "res.r = par.p" : svc() + ".o" + number(2) + "()";
    if (chance(0.2)) s.exit = chance(0.7) ? "var.v = 1" : svc() + ".o" + number(2) + "(par.p)";
    if (!s.ports.empty() && chance(0.2)) {
      s.keep.emplace();
      s.keep->any = chance(0.5);
      if (!s.keep->any) s.keep->ports.push_back(s.ports[pick(s.ports.size())].name);
      s.keep->deep = states_ % 2 == 0;  // no draw: seeds give the models that they gave before
    }
    return s;
  }

  std::mt19937_64 random_;
  bool data_;
  int states_ = 0;
  bool deep_ = false;
};

}  // namespace race::semantics
