#include "core/execution/script.h"

#include <utility>

#include "core/execution/scripted_services.h"
#include "core/execution/step_json.h"

namespace race::execution {

using semantics::OutgoingCall;

namespace {

// The inputs of a script step join those that wait.
void post(Execution& execution, const ScriptStep& step) {
  for (const ScriptEvent& event : step.events) execution.post_event(event.service, event.event, event.data);
  for (const ScriptResponse& response : step.responses) {
    const std::uint64_t call = execution.run().find_call(response.service, response.operation, response.call);
    if (call != 0) execution.post_response(call, response.is_error, response.data);
  }
}

}  // namespace

Checked<Value> derive(const rcm::NativeModel& model, const Script& script, OrderChoice order) {
  std::map<std::string, rsm::Service> models(script.services.begin(), script.services.end());
  auto program = semantics::Program::build(model, models);
  if (!program) return tl::unexpected(std::move(program).error());
  auto execution = Execution::create(*program, script.arguments);
  if (!execution) return tl::unexpected(std::vector<Error>{std::move(execution).error()});
  execution->set_order(make_order(**program, order));
  ScriptedServices services(script, *execution);
  List steps;
  for (const ScriptStep& step : script.steps) {
    if (execution->is_over()) break;
    post(*execution, step);
    const Progress& progress = execution->step({.entry = false, .derivation = true});
    for (const OutgoingCall& call : progress.calls) services.call(call);
    steps.push_back(derived_step(*execution, progress));
    services.step(step);
  }
  Dict document;
  document.set("steps", std::move(steps));
  set_status(execution->run(), document);
  return Value(std::move(document));
}

}  // namespace race::execution
