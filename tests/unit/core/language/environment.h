// A state to run code in: one parameter, some results and variables, a child with a port, and the service t.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/language/check/checker.h"
#include "core/language/compile/code.h"
#include "core/language/evaluate/interpreter.h"
#include "core/value/json.h"

namespace race::language::test {

class State final : public Environment {
 public:
  enum : ValueIndex { par_a, res_out, res_x, res_unset, var_n, var_log, child_x, slot_count };
  enum : Flag { port_p, child_active, child_port_q, barrier_active, flag_count };

  State() : slots_(slot_count, Value::unknown()), flags_(flag_count, 0) {
    symbols.parameters = {{"a", par_a}};
    symbols.results = {{"out", res_out}, {"x", res_x}, {"unset", res_unset}};
    symbols.variables = {{"n", var_n}, {"log", var_log}};
    symbols.ports = {{"p", port_p}};
    ChildSymbols child;
    child.active = child_active;
    child.results = {{"x", child_x}};
    child.ports = {{"q", child_port_q}};
    symbols.children.emplace("C", child);
    ChildSymbols barrier;
    barrier.barrier = true;
    barrier.active = barrier_active;
    symbols.children.emplace("b", barrier);
    table.declare_event("t", "data", false);
    table.declare_event("t", "sample", true);
    table.declare_operation("t", "op", false);
    event_values_.assign(16, Value::unknown());
    sampled_flags_.assign(16, 0);
    sampled_flags_[1] = 1;
    responses_.assign(32, Value::unknown());
    refresh();
  }

  void set(ValueIndex slot, Value value) { slots_[slot] = std::move(value); }
  void raise(Flag flag, bool on = true) { flags_[flag] = on ? 1 : 0; }
  const Value& at(ValueIndex slot) const { return slots_[slot]; }
  void deliver(EventId event, Value data) {
    event_values_[event] = std::move(data);
    occurrence = event;
  }
  void answer(OperationId operation, bool error, Value data) {
    responses_[operation * 2 + (error ? 1U : 0U)] = std::move(data);
  }

  const Value& response(OperationId operation, std::string_view, bool error) override {
    return responses_[operation * 2 + (error ? 1U : 0U)];
  }
  void write(ValueIndex slot, Value value) override { slots_[slot] = std::move(value); }
  void call(OperationId, std::string_view service, std::string_view name, List args, Dict kwargs) override {
    calls.push_back(std::string(service) + "." + std::string(name) + to_json(Value(std::move(args))) +
                    to_json(Value(std::move(kwargs))));
  }
  const ServiceTable& services() const override { return table; }
  void print(std::string text) override { printed += text; }

  Symbols symbols;
  ServiceTable table;
  std::vector<std::string> calls;
  std::string printed;

 private:
  void refresh() {
    values = slots_.data();
    flags = flags_.data();
    event_data = event_values_.data();
    sampled = sampled_flags_.data();
  }
  std::vector<Value> slots_, event_values_, responses_;
  std::vector<std::uint8_t> flags_, sampled_flags_;
};

/// The result of a code: a value or truth as text, "unknown", "unmet", or "fault KIND".
class Runner {
 public:
  Runner() = default;
  explicit Runner(Interpreter::Limits limits) : interpreter(limits) {}

  Code code(std::string_view text, CodeKind kind) {
    auto compiled = compile(text, kind, state.symbols, state.table);
    if (compiled) return *compiled;
    refused = to_string(compiled.error().front());
    return {};
  }
  std::string fault() const { return "fault " + std::string(name(interpreter.fault().kind)); }

  std::string condition(std::string_view text) {
    const Code compiled = code(text, CodeKind::condition);
    if (!compiled) return refused;
    switch (interpreter.condition(compiled, state)) {
      case Truth::yes:
        return "True";
      case Truth::no:
        return "False";
      case Truth::unknown:
        return "unknown";
      default:
        return fault();
    }
  }
  std::string expression(std::string_view text) {
    const Code compiled = code(text, CodeKind::expression);
    if (!compiled) return refused;
    const auto value = interpreter.expression(compiled, state);
    return !value ? fault() : value->is_unknown() ? "unknown" : to_json(*value);
  }
  /// Runs a function; "" if it completed.
  std::string function(std::string_view text) {
    const Code compiled = code(text, CodeKind::function);
    if (!compiled) return refused;
    switch (interpreter.function(compiled, state)) {
      case Interpreter::Outcome::done:
        return "";
      case Interpreter::Outcome::unmet:
        return "unmet";
      default:
        return fault();
    }
  }
  /// res.out after a function, or why it stopped.
  std::string out(std::string_view text) {
    const std::string stopped = function(text);
    if (!stopped.empty()) return stopped;
    return state.at(State::res_out).is_unknown() ? "unknown" : to_json(state.at(State::res_out));
  }

  State state;
  Interpreter interpreter;
  std::string refused;
};

}  // namespace race::language::test
