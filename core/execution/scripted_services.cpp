#include "core/execution/scripted_services.h"

#include <algorithm>

namespace race::execution {

using semantics::OutgoingCall;

namespace {

bool declares(const rsm::Service& service, const std::string& operation) {
  return std::ranges::find(service.operations, operation, &rsm::Operation::name) != service.operations.end();
}

}  // namespace

ScriptedServices::ScriptedServices(const Script& script, Execution& execution)
    : script_(script), execution_(execution) {
  for (const auto& [key, service] : script.services) instances_.push_back(rsm::initial(service));
}

void ScriptedServices::call(const OutgoingCall& call) {
  const auto found = std::ranges::find(script_.services, call.service, [](const auto& entry) { return entry.first; });
  if (found == script_.services.end() || !declares(found->second, call.name)) {
    if (!script_.closed) reject(call, "unavailable");  // R7
    return;
  }
  const rsm::Service& service = found->second;
  if (service.is_interface()) return;  // the script answers
  rsm::Instance& instance = instances_[static_cast<std::size_t>(found - script_.services.begin())];
  const auto effect = rsm::Trans1(service, instance, call.name, call.number);
  if (!effect) return reject(call, "not_accepted");
  put(call.service, *effect);
}

void ScriptedServices::step(const ScriptStep& step) {
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const auto& [key, service] = script_.services[i];
    if (service.is_interface() || take_transition(i, step)) continue;
    for (const std::string& event : rsm::Stutter(service, instances_[i]).events)
      if (!waits(key, event)) execution_.post_event(key, event, Value());
  }
}

// The first transition that the step names for the service and that applies.
bool ScriptedServices::take_transition(std::size_t service, const ScriptStep& step) {
  const auto& [key, model] = script_.services[service];
  for (const ScriptTransition& each : step.transitions) {
    if (each.service != key) continue;
    if (const auto effect = rsm::Trans2(model, instances_[service], each.id, each.call)) {
      put(key, *effect);
      return true;
    }
  }
  return false;
}

void ScriptedServices::reject(const OutgoingCall& call, const char* code) {
  execution_.post_response(call.number, true, Dict{{"code", code}});
}

void ScriptedServices::put(const std::string& service, const rsm::Effect& effect) {
  for (const rsm::Answer& answer : effect.answers) {
    Value data;
    if (answer.is_error)
      data = Dict{{"code", answer.error_code}};
    else if (const Value* result = script_.results.find(service + "." + answer.operation))
      data = *result;
    execution_.post_response(answer.call, answer.is_error, std::move(data));
  }
  for (const std::string& event : effect.events) execution_.post_event(service, event, Value());
}

bool ScriptedServices::waits(const std::string& service, const std::string& event) const {
  return execution_.waiting().contains(execution_.run().program().services.find_event(service, event));
}

}  // namespace race::execution
