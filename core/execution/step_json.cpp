#include "core/execution/step_json.h"

namespace race::execution {

using semantics::OutgoingCall;
using semantics::Run;

Value call_json(const OutgoingCall& call) {
  return Dict{{"call", static_cast<std::int64_t>(call.number)},
              {"service", call.service},
              {"operation", call.name},
              {"args", call.args},
              {"kwargs", call.kwargs}};
}

List calls_json(const std::vector<OutgoingCall>& calls) {
  List list;
  for (const OutgoingCall& call : calls) list.push_back(call_json(call));
  return list;
}

List micro_steps_json(const semantics::Program& program, const semantics::Derivation& derivation) {
  List micro;
  for (std::size_t i = 0; i < derivation.micro.size(); ++i)
    micro.push_back(semantics::derivation_json(program, derivation, i));
  return micro;
}

Dict trace_step(const semantics::Program& program, const Progress& progress) {
  Dict json{{"step", static_cast<std::int64_t>(progress.position)}};
  if (progress.entry) json.set("input", input_json(*progress.entry));
  json.set("micro", progress.derivation ? micro_steps_json(program, *progress.derivation) : List());
  json.set("calls", calls_json(progress.calls));
  return json;
}

Value derived_step(const Execution& execution, const Progress& progress) {
  List calls;
  for (const OutgoingCall& call : progress.calls)
    calls.emplace_back(
        Dict{{"service", call.service}, {"operation", call.name}, {"args", call.args}, {"kwargs", call.kwargs}});
  List micro;
  if (progress.derivation) micro = micro_steps_json(execution.run().program(), *progress.derivation);
  return Dict{{"micro", std::move(micro)}, {"calls", std::move(calls)}, {"state", execution.run().state_json()}};
}

List obstacles_json(const std::vector<semantics::Obstacle>& obstacles) {
  List list;
  for (const semantics::Obstacle& obstacle : obstacles) {
    Dict json{{"path", obstacle.path}};
    if (!obstacle.id.empty()) json.set("id", obstacle.id);
    if (!obstacle.parameter.empty()) json.set("parameter", obstacle.parameter);
    list.emplace_back(std::move(json));
  }
  return list;
}

Value root_results(const Run& run) {
  Dict results;
  const semantics::StateInfo& root = run.program()[semantics::Program::root];
  for (std::size_t i = 0; i < root.results.size(); ++i) {
    const Value& value = run.state().values[root.first_result + i];
    if (!value.is_unknown()) results.set(root.results[i], value);
  }
  return results;
}

Value fault_json(const semantics::RunFault& fault) {
  return Dict{{"kind", language::name(fault.kind)}, {"at", fault.at}, {"message", fault.message}};
}

void set_status(const Run& run, Dict& json) {
  json.set("status", semantics::name(run.status()));
  if (run.status() == semantics::Status::ended) json.set("outcome", run.outcome());
  if (run.fault()) json.set("fault", fault_json(*run.fault()));
}

}  // namespace race::execution
