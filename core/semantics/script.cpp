#include "core/semantics/script.h"

#include <algorithm>
#include <utility>

#include "core/rsm/rules.h"

namespace race::semantics {
namespace {

// Ω of a script: its services, which answer calls by their rules or wait for the script to answer.
class ScriptedEnvironment {
 public:
  ScriptedEnvironment(const Script& script, Run& run) : script_(script), run_(run) {
    for (const auto& [key, service] : script.services) instances_.push_back(rsm::initial(service));
  }

  /// The handshake of FuncSC (4.14) with Trans1 (4.4).
  void call(const OutgoingCall& call) {
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

  /// Exec (4.20), its second part: each service takes Trans2 (4.5) as the script says, or Stutter (4.6).
  void step_services(const ScriptStep& step) {
    for (std::size_t i = 0; i < instances_.size(); ++i) {
      const auto& [key, service] = script_.services[i];
      if (service.is_interface()) continue;
      bool taken = false;
      for (const auto& [name, id] : step.transitions) {
        if (taken || name != key) continue;
        if (const auto effect = rsm::Trans2(service, instances_[i], id)) {
          put(key, *effect);
          taken = true;
        }
      }
      if (taken) continue;
      for (const std::string& event : rsm::Stutter(service, instances_[i]).events)
        if (!waits(key, event)) run_.post_event(key, event, Value());
    }
  }

 private:
  static bool declares(const rsm::Service& service, const std::string& operation) {
    return std::ranges::find(service.operations, operation, &rsm::Operation::name) != service.operations.end();
  }
  void reject(const OutgoingCall& call, const char* code) {
    run_.post_response(call.number, true, Dict{{"code", code}});
  }
  void put(const std::string& service, const rsm::Effect& effect) {
    for (const rsm::Answer& answer : effect.answers) {
      Value data;
      if (answer.is_error)
        data = Dict{{"code", answer.error_code}};
      else if (const Value* result = script_.results.find(service + "." + answer.operation))
        data = *result;
      run_.post_response(answer.call, answer.is_error, std::move(data));
    }
    for (const std::string& event : effect.events) run_.post_event(service, event, Value());
  }
  bool waits(const std::string& service, const std::string& event) const {
    const EventId id = run_.program().services.find_event(service, event);
    return std::ranges::any_of(run_.state().waiting, [&](const Input& input) {
      return input.kind == Input::Kind::event && input.number == id;
    });
  }

  const Script& script_;
  Run& run_;
  std::vector<rsm::Instance> instances_;  // by service of the script
};

// The inputs of a script step join those that wait.
void post(Run& run, const ScriptStep& step) {
  for (const ScriptEvent& event : step.events) run.post_event(event.service, event.event, event.data);
  for (const ScriptResponse& response : step.responses) {
    const std::uint64_t call = run.find_call(response.service, response.operation, response.call);
    if (call != 0) run.post_response(call, response.is_error, response.data);
  }
}

}  // namespace

Value step_json(const Run& run, const Derivation& derivation, const std::vector<OutgoingCall>& calls) {
  List micro, out;
  for (std::size_t i = 0; i < derivation.micro.size(); ++i)
    micro.push_back(derivation_json(run.program(), derivation, i));
  for (const OutgoingCall& call : calls)
    out.emplace_back(
        Dict{{"service", call.service}, {"operation", call.name}, {"args", call.args}, {"kwargs", call.kwargs}});
  return Dict{{"micro", std::move(micro)}, {"calls", std::move(out)}, {"state", run.state_json()}};
}

void set_status(const Run& run, Dict& document) {
  document.set("status", name(run.status()));
  if (run.status() == Status::ended) document.set("outcome", run.outcome());
  if (run.fault())
    document.set(
        "fault",
        Dict{{"kind", language::name(run.fault()->kind)}, {"at", run.fault()->at}, {"message", run.fault()->message}});
}

Checked<Value> derive(const rcm::NativeModel& model, const Script& script) {
  std::map<std::string, rsm::Service> services(script.services.begin(), script.services.end());
  auto program = Program::build(model, services);
  if (!program) return tl::unexpected(std::move(program).error());
  auto created = Run::create(*program, script.arguments);
  if (!created) return tl::unexpected(std::vector<Error>{std::move(created).error()});
  Run& run = *created;
  ScriptedEnvironment environment(script, run);
  List steps;
  for (const ScriptStep& step : script.steps) {
    if (run.status() != Status::running) break;
    post(run, step);
    TreeRecorder recorder;
    std::vector<OutgoingCall> calls;
    run.begin(run.take_input());
    for (bool more = true; more;) {
      more = run.micro(recorder);
      for (OutgoingCall& call : run.take_calls()) {
        if (run.status() != Status::faulted) environment.call(call);
        calls.push_back(std::move(call));
      }
    }
    steps.push_back(step_json(run, recorder.derivation, calls));
    if (run.status() == Status::running) environment.step_services(step);
  }
  Dict document;
  document.set("steps", std::move(steps));
  set_status(run, document);
  return Value(std::move(document));
}

}  // namespace race::semantics
