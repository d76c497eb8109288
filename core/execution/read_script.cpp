#include "core/execution/input_fields.h"
#include "core/execution/script.h"
#include "core/rsm/document.h"
#include "core/value/fields.h"

namespace race::execution {
namespace {

std::string required_text(Fields& fields, std::string_view key) { return fields.text(key, kRequired).value_or(""); }

// An object; nothing if it is absent or of another type.
const Dict* object(Fields& fields, std::string_view key) {
  const Value* found = fields.find(key);
  if (found && found->is_dict()) return &found->as_dict();
  if (found) fields.violation(ErrorCode::type, std::string(key) + " is not an object");
  return nullptr;
}

ScriptEvent read_event(const Value& json, const std::string& path, std::vector<Error>& errors) {
  Fields fields(json, path, "event", errors);
  ScriptEvent event{required_text(fields, "service"), required_text(fields, "event"), {}};
  if (const Value* data = fields.find("data")) event.data = *data;
  fields.close();
  return event;
}

/// The number of a call; 0: none is named.
std::uint64_t read_call(Fields& fields) {
  const Value* call = fields.find("call");
  if (!call) return 0;
  if (call->is_integer() && call->as_integer() > 0) return static_cast<std::uint64_t>(call->as_integer());
  fields.violation(ErrorCode::type, "call is not a number from 1");
  return 0;
}

ScriptResponse read_response(const Value& json, const std::string& path, std::vector<Error>& errors) {
  Fields fields(json, path, "response", errors);
  ScriptResponse response{
      required_text(fields, "service"), required_text(fields, "operation"), read_call(fields), false, {}};
  const Value* result = fields.find("result");
  const Value* error = fields.find("error");
  if ((result == nullptr) == (error == nullptr))
    fields.violation(ErrorCode::missing, "a response has either a result or an error");
  response.is_error = error != nullptr;
  if (result || error) response.data = error ? *error : *result;
  fields.close();
  return response;
}

ScriptStep read_step(const Value& json, const std::string& path, std::vector<Error>& errors) {
  ScriptStep step;
  Fields fields(json, path, "step", errors);
  fields.find("doc");
  for (const Value& item : fields.list("events")) step.events.push_back(read_event(item, path, errors));
  for (const Value& item : fields.list("responses")) step.responses.push_back(read_response(item, path, errors));
  if (const Value* json = fields.find("edit")) {
    if (auto edit = edit::read_edit(*json))
      step.edit = std::move(*edit);
    else
      append_below(errors, std::move(edit).error(), path + "/edit");
  }
  if (const Value* json = fields.find("force")) {
    Fields force(*json, path + "/force", "force", errors);
    step.force = read_force(force);
    force.close();
  }
  if (step.edit && step.force) fields.violation(ErrorCode::conflict, "a step has an edit or a force, not both");
  for (const Value& item : fields.list("transitions")) {
    Fields transition(item, path, "transition", errors);
    step.transitions.push_back(
        {required_text(transition, "service"), required_text(transition, "id"), read_call(transition)});
    transition.close();
  }
  fields.close();
  return step;
}

}  // namespace

Checked<Script> read_script(const Value& json) {
  std::vector<Error> errors;
  Script script;
  Fields fields(json, "", "script", errors);
  fields.find("doc");
  if (const Dict* arguments = object(fields, "arguments")) script.arguments = *arguments;
  if (const Dict* results = object(fields, "results")) script.results = *results;
  if (const Dict* services = object(fields, "services")) {
    for (const auto& [key, value] : *services) {
      auto service = rsm::read_service(value, "services/" + key.as_string());
      if (service)
        script.services.emplace_back(key.as_string(), std::move(*service));
      else
        append_below(errors, std::move(service).error(), "");
    }
  }
  if (const Value* closed = fields.find("closed")) {
    if (!closed->is_bool()) fields.violation(ErrorCode::type, "closed is not a bool");
    script.closed = closed->is_bool() && closed->as_bool();
  }
  std::size_t number = 0;
  for (const Value& step : fields.list("steps"))
    script.steps.push_back(read_step(step, "steps/" + std::to_string(number++), errors));
  fields.close();
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return script;
}

}  // namespace race::execution
