// Tools of the cell: STOP, a call of a service by hand, and what is there.
#include "server/mcp/tool.h"

namespace race::server::mcp {
namespace {

const List kNobody;

const List& services_in(const Value& answer) {
  const Value* services = answer.find("services");
  return services && services->is_list() ? services->as_list() : kNobody;
}

// Whether a service has an operation of this name that changes nothing.
bool can_tell(const Value& service, std::string_view operation) {
  const Value* rsm = service.find("rsm");
  const Value* operations = rsm ? rsm->find("operations") : nullptr;
  if (!operations || !operations->is_list()) return false;
  for (const Value& each : operations->as_list()) {
    const Value* name = each.find("name");
    const Value* reads = each.find("reads");
    if (name && *name == Value(operation) && reads && *reads == Value(true)) return true;
  }
  return false;
}

Value either(const Outcome& outcome) { return outcome ? *outcome : Value(problem_json(outcome.error())); }

// What each service answers that has this operation, by its key.
Dict told(const Context& context, const Value& services, std::string_view operation) {
  Dict answers;
  for (const Value& service : services_in(services)) {
    const Value* key = service.find("key");
    if (!key || !key->is_string() || !can_tell(service, operation)) continue;
    const Dict body{{"operation", operation}};
    answers.set(*key, either(context.api.post(Target{"services", key->as_string(), "calls"}, body)));
  }
  return answers;
}

// The error of a service, whose fields are its own but for `code`.
Problem problem_of(const Dict& arguments, const Value& error) {
  const std::string path = text_of(arguments, "service") + '.' + text_of(arguments, "operation");
  Dict json = error.is_dict() ? error.as_dict() : Dict{{"code", error}};
  json.set("path", path);
  if (!error.find("message")) json.set("message", "the service answers with an error");
  return {0, Dict{{"errors", List{std::move(json)}}}};
}

}  // namespace

Outcome stop_cell(const Context& context, const Dict&) { return context.api.post(Target{"stop"}); }

Outcome call_service(const Context& context, const Dict& arguments) {
  Dict body;
  for (const char* name : {"operation", "args", "kwargs"})
    if (const Value* value = arguments.find(name)) body.set(name, *value);
  const auto response = context.api.post(Target{"services", text_of(arguments, "service"), "calls"}, body);
  if (!response) return response;
  if (const Value* error = response->find("error")) return tl::unexpected(problem_of(arguments, *error));
  return response;
}

// What one part of it refuses, such as a call that an observer may not make, stands in its place.
Outcome read_cell(const Context& context, const Dict& arguments) {
  const auto services = context.api.get(Target{"services"});
  if (!services) return services;
  Dict cell{{"scene", either(context.api.get(Target{"cell"}))},
            {"control", either(context.api.get(Target{"control"}))},
            {"robots", told(context, *services, "state")}};
  const Value* objects = arguments.find("objects");
  if (objects && objects->as_bool()) cell.set("objects", told(context, *services, "look"));
  return cell;
}

}  // namespace race::server::mcp
