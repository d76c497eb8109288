#include "core/rsm/document.h"
#include "core/semantics/script.h"

namespace race::semantics {
namespace {

// Reads one JSON object field by field and lists what is wrong with it.
class Fields {
 public:
  Fields(const Value& json, std::string path, std::vector<Error>& errors)
      : json_(json), path_(std::move(path)), errors_(errors) {
    if (!json.is_dict()) error(ErrorCode::type, "expected an object");
  }
  void allow(std::initializer_list<std::string_view> names) {
    if (!json_.is_dict()) return;
    for (const auto& [key, value] : json_.as_dict()) {
      bool known = false;
      for (const std::string_view name : names) known = known || name == key.as_string();
      if (!known) error(ErrorCode::unknown_field, "field " + key.as_string() + " is not known");
    }
  }
  const Value* optional(std::string_view name, bool (Value::*is)() const noexcept, std::string_view expected) {
    const Value* found = json_.find(name);
    if (!found || (found->*is)()) return found;
    error(ErrorCode::type, std::string(name) + " is not " + std::string(expected));
    return nullptr;
  }
  std::string text(std::string_view name) {
    const Value* found = optional(name, &Value::is_string, "a string");
    if (!json_.find(name)) error(ErrorCode::missing, "field " + std::string(name) + " is missing");
    return found ? found->as_string() : std::string();
  }
  List list(std::string_view name) {
    const Value* found = optional(name, &Value::is_list, "a list");
    return found ? found->as_list() : List();
  }
  const Value* find(std::string_view name) const { return json_.find(name); }
  void error(ErrorCode code, std::string message) { errors_.push_back({code, std::move(message), path_}); }

 private:
  const Value& json_;
  std::string path_;
  std::vector<Error>& errors_;
};

ScriptStep read_step(const Value& json, const std::string& path, std::vector<Error>& errors) {
  ScriptStep step;
  Fields fields(json, path, errors);
  fields.allow({"events", "responses", "transitions", "doc"});
  for (const Value& item : fields.list("events")) {
    Fields event(item, path, errors);
    event.allow({"service", "event", "data"});
    const Value* data = event.find("data");
    step.events.push_back({event.text("service"), event.text("event"), data ? *data : Value()});
  }
  for (const Value& item : fields.list("responses")) {
    Fields response(item, path, errors);
    response.allow({"service", "operation", "call", "result", "error"});
    ScriptResponse out{response.text("service"), response.text("operation"), 0, false, {}};
    if (const Value* call = response.optional("call", &Value::is_integer, "an integer"))
      out.call = static_cast<std::uint64_t>(call->as_integer());
    const Value* result = response.find("result");
    const Value* error = response.find("error");
    if ((result == nullptr) == (error == nullptr))
      response.error(ErrorCode::missing, "a response has either a result or an error");
    out.is_error = error != nullptr;
    if (result || error) out.data = error ? *error : *result;
    step.responses.push_back(std::move(out));
  }
  for (const Value& item : fields.list("transitions")) {
    Fields transition(item, path, errors);
    transition.allow({"service", "id"});
    step.transitions.emplace_back(transition.text("service"), transition.text("id"));
  }
  return step;
}

}  // namespace

Checked<Script> read_script(const Value& json) {
  std::vector<Error> errors;
  Script script;
  Fields fields(json, "", errors);
  fields.allow({"arguments", "services", "results", "steps", "doc"});
  if (const Value* arguments = fields.optional("arguments", &Value::is_dict, "an object"))
    script.arguments = arguments->as_dict();
  if (const Value* results = fields.optional("results", &Value::is_dict, "an object"))
    script.results = results->as_dict();
  if (const Value* services = fields.optional("services", &Value::is_dict, "an object")) {
    for (const auto& [key, value] : services->as_dict()) {
      auto service = rsm::read_service(value, "services/" + key.as_string());
      if (service)
        script.services.emplace_back(key.as_string(), std::move(*service));
      else
        errors.insert(errors.end(), service.error().begin(), service.error().end());
    }
  }
  std::size_t number = 0;
  for (const Value& step : fields.list("steps"))
    script.steps.push_back(read_step(step, "steps/" + std::to_string(number++), errors));
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return script;
}

}  // namespace race::semantics
