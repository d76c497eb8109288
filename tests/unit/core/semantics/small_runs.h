// Small models as JSON and a run of each, for tests of single rules: post an input, take one macro step, look.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/rcm/document.h"
#include "core/rcm/translate.h"
#include "core/value/json.h"
#include "tests/unit/core/semantics/driven_run.h"

namespace race::semantics {

/// A run of `{"rcm": 1, "root": root}`; quotes in `root` may be written '. Services `t` and `u`, alike: events a, b and
/// the sampled s; operations f, g, and halt and off, which are safe.
class SmallRun {
 public:
  explicit SmallRun(std::string root, const Dict& arguments = {}, Budgets budgets = {})
      : run_(create(std::move(root), arguments, budgets)) {}

  /// One macro step with the first waiting input. Returns its micro steps: "PTrigger A.p, SDeact2 A" and so on, by name
  /// of the node, only rules of the activation and micro layer and executed actions.
  std::vector<std::string> step(const Order& order = Order::declared()) {
    TreeRecorder recorder;
    run_.macro_step(recorder, order);
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < recorder.derivation.micro.size(); ++i) {
      std::string line;
      collect(derivation_json(run_.program(), recorder.derivation, i), line);
      lines.push_back(line);
    }
    return lines;
  }
  std::vector<std::string> event(std::string_view name, Value x = Value(0)) {
    run_.post_event("t", name, Dict{{"x", std::move(x)}});
    return step();
  }
  std::vector<std::string> result(std::uint64_t call, Value data) {
    run_.post_response(call, false, std::move(data));
    return step();
  }
  /// The calls since the last time: "t.f(1)#2" is call 2.
  std::vector<std::string> calls() {
    std::vector<std::string> out;
    for (const OutgoingCall& call : run_.take_calls()) {
      std::string args = to_json(Value(call.args));
      out.push_back(call.service + "." + call.name + "(" + args.substr(1, args.size() - 2) + ")#" +
                    std::to_string(call.number));
    }
    return out;
  }
  /// The names of the active nodes, in tree order.
  std::string active() const {
    std::string out;
    const Value state = run_.state_json();
    for (const Value& path : state.find("active")->as_list()) out += (out.empty() ? "" : " ") + name_of(path);
    return out;
  }
  /// An entry of the state: group "results", "variables", "parameters", "activated"; unknown if there is none.
  Value get(std::string_view group, std::string_view path, std::string_view name) const {
    const Value state = run_.state_json();
    const Value* node = state.find(group)->find(path);
    const Value* found = node ? node->find(name) : nullptr;
    return found ? *found : Value::unknown();
  }
  DrivenRun& operator*() { return run_; }
  DrivenRun* operator->() { return &run_; }

  /// The program of such a root.
  static std::shared_ptr<const Program> program(std::string root) {
    for (char& c : root) c = c == '\'' ? '"' : c;
    auto document = rcm::read_document_text(R"({"rcm": 1, "root": )" + root + "}");
    if (!document) throw std::runtime_error(to_string(document.error()[0]));
    auto native = rcm::translate(*document);
    if (!native) throw std::runtime_error(to_string(native.error()[0]));
    rsm::Service service;
    for (const char* name : {"a", "b", "s"}) {
      rsm::Event event;
      event.name = name;
      event.sampled = event.name == "s";
      service.events.push_back(event);
    }
    for (const char* name : {"f", "g", "off", "halt"}) {
      rsm::Operation operation;
      operation.name = name;
      operation.safe = operation.name.size() > 1;
      service.operations.push_back(operation);
    }
    auto program = Program::build(*native, {{"t", service}, {"u", service}});
    if (!program) throw std::runtime_error(to_string(program.error()[0]));
    return *program;
  }

 private:
  static DrivenRun create(std::string root, const Dict& arguments, Budgets budgets) {
    return DrivenRun(*Run::create(program(std::move(root)), arguments, budgets));
  }
  static std::string name_of(const Value& path) { return path.as_string().substr(path.as_string().rfind('/') + 1); }

  static void collect(const Value& node, std::string& line) {
    const std::string& rule = node.find("rule")->as_string();
    const auto shown = [&](std::string_view prefix) { return rule.starts_with(prefix); };
    if (shown("SDeact") || shown("SAct") || shown("BAct") || shown("BDeact") || shown("PTr") || shown("SProp") ||
        (shown("Action") && rule != "Action3")) {
      line += (line.empty() ? "" : ", ") + rule + " " + name_of(*node.find("at"));
      if (rule == "PTrigger") line += "." + node.find("port")->as_string();
      if (const Value* action = node.find("action")) line += "#" + std::to_string(action->as_integer());
      if (const Value* refinement = node.find("refinement"); refinement && rule == "Action2")
        line += " " + refinement->as_string();
    }
    for (const Value& premise : node.find("premises")->as_list()) collect(premise, line);
  }

  DrivenRun run_;
};

}  // namespace race::semantics
