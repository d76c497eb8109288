#include "core/language/code.h"

#include <algorithm>
#include <array>

#include "core/language/machine_internal.h"
#include "core/language/shortcuts_internal.h"

namespace race::language {

std::string_view name(FaultKind kind) {
  static constexpr std::array<std::string_view, 10> kNames = {
      "type", "missing", "zero_division", "overflow", "budget", "value", "name", "unmet", "unresolved", "divergence"};
  static_assert(kNames.size() == static_cast<std::size_t>(FaultKind::divergence) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

// The service table.

EventId ServiceTable::declare_event(std::string_view service, std::string_view name, bool sampled) {
  const EventId id = event(service, name);
  events_[id].sampled = sampled;
  events_[id].declared = true;
  return id;
}

OperationId ServiceTable::declare_operation(std::string_view service, std::string_view name, bool safe) {
  const OperationId id = operation(service, name);
  operations_[id].safe = safe;
  operations_[id].declared = true;
  return id;
}

EventId ServiceTable::event(std::string_view service, std::string_view name) {
  const auto [at, is_new] = event_ids_.try_emplace(Key(service, name), static_cast<EventId>(events_.size()));
  if (is_new) events_.push_back({std::string(service), std::string(name)});
  return at->second;
}

OperationId ServiceTable::operation(std::string_view service, std::string_view name) {
  const auto [at, is_new] =
      operation_ids_.try_emplace(Key(service, name), static_cast<OperationId>(operations_.size()));
  if (is_new) operations_.push_back({std::string(service), std::string(name)});
  return at->second;
}

OperationId ServiceTable::open_operation(std::string_view name) {
  const auto [at, is_new] = open_ids_.try_emplace(std::string(name), static_cast<OperationId>(operations_.size()));
  if (is_new) operations_.push_back({.service = {}, .name = std::string(name), .open = true});
  return at->second;
}

EventId ServiceTable::find_event(std::string_view service, std::string_view name) const {
  const auto found = event_ids_.find(Key(service, name));
  return found == event_ids_.end() ? kNone : found->second;
}

OperationId ServiceTable::find_operation(std::string_view service, std::string_view name) const {
  const auto found = operation_ids_.find(Key(service, name));
  return found == operation_ids_.end() ? kNone : found->second;
}

OperationId ServiceTable::dynamic_operation(std::string_view service, std::string_view name) const {
  const OperationId found = find_operation(service, name);
  if (found != kNone) return found;
  const auto open = open_ids_.find(name);
  return open == open_ids_.end() ? kNone : open->second;
}

std::vector<std::string> ServiceTable::declared_services() const {
  std::vector<std::string> names;
  const auto add = [&](const auto& entry) {
    if (entry.declared && std::find(names.begin(), names.end(), entry.service) == names.end())
      names.push_back(entry.service);
  };
  for (const Event& event : events_) add(event);
  for (const Operation& operation : operations_) add(operation);
  return names;
}

// Code and Interpreter.

CodeKind Code::kind() const { return program_->kind; }
const std::string& Code::text() const { return program_->text; }
const Mentions& Code::mentions() const { return program_->mentions; }

Interpreter::Interpreter() : Interpreter(Limits()) {}
Interpreter::Interpreter(Limits limits) : state_(std::make_unique<State>(limits)) {}
Interpreter::~Interpreter() = default;

Truth Interpreter::condition(const Code& code, Environment& environment) {
  const Program& program = code.program();
  if (program.comparison.datum != Op::pass && environment.trace == nullptr && state_->steps >= Comparison::kUnits)
    if (const auto truth = decide(program, environment)) return *truth;
  return state_->machine.condition(program, environment);
}
std::optional<Value> Interpreter::expression(const Code& code, Environment& environment) {
  return state_->machine.expression(code.program(), environment);
}
Interpreter::Outcome Interpreter::function(const Code& code, Environment& environment) {
  return state_->machine.function(code.program(), environment);
}
const Fault& Interpreter::fault() const { return state_->machine.fault(); }

}  // namespace race::language
