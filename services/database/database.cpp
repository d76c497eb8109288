#include "services/database/database.h"

#include "core/rsm/document.h"
#include "services/arguments.h"

namespace race::database {
namespace {

constexpr std::string_view kModel = R"json({
  "rsm": 1, "name": "database",
  "operations": [
    {"name": "get", "parameters": [{"name": "key", "type": "string"}], "result": "any",
     "error": {"record": {"code": "string", "message": "string"}},
     "doc": "The value stored under `key`; error `not_found`."},
    {"name": "add", "parameters": [{"name": "key", "type": "string"}, {"name": "value", "type": "any"}],
     "result": "string", "error": {"record": {"code": "string", "message": "string"}},
     "doc": "Stores a pose, a transform or any other value under `key`, over an old one; answers the key."},
    {"name": "remove", "parameters": [{"name": "key", "type": "string"}], "result": "string",
     "error": {"record": {"code": "string", "message": "string"}},
     "doc": "Forgets `key`; answers the key; error `not_found`."},
    {"name": "list", "parameters": [{"name": "prefix", "type": "string", "value": ""}], "result": {"list": "string"},
     "error": {"record": {"code": "string", "message": "string"}},
     "doc": "The keys that begin with `prefix`, sorted."}
  ],
  "events": [],
  "states": [{"name": "Ready"}], "init": "Ready",
  "transitions": [
    {"id": "get", "dst": "Ready", "operation": "get"},
    {"id": "add", "dst": "Ready", "operation": "add"},
    {"id": "remove", "dst": "Ready", "operation": "remove"},
    {"id": "list", "dst": "Ready", "operation": "list"}
  ]
})json";

}  // namespace

const rsm::Service& model() {
  static const rsm::Service service = rsm::read_service_text(kModel, "services/database").value();
  return service;
}

Database::Database(Store store, services::ServiceHost& host) : store_(std::move(store)), host_(host) {}

void Database::call(const services::Call& call) {
  // Each transition has the name of its operation.
  host_.transition(call.operation, call.id);
  auto value = answer(call);
  if (value) {
    host_.result(call.id, std::move(*value));
  } else {
    host_.error(call.id, services::error_value(value.error()));
  }
}

Expected<Value> Database::answer(const services::Call& call) {
  ASSIGN_OR_RETURN(const Dict arguments,
                   services::bind_arguments(*services::find_operation(model(), call.operation), call));
  if (call.operation == "list") {
    ASSIGN_OR_RETURN(const auto keys, store_.keys(arguments.find("prefix")->as_string()));
    return Value(List(keys.begin(), keys.end()));
  }
  const Value& key = *arguments.find("key");
  if (call.operation == "get") return store_.get(key.as_string());
  const auto done =
      call.operation == "add" ? store_.put(key.as_string(), *arguments.find("value")) : store_.remove(key.as_string());
  if (!done) return tl::unexpected(done.error());
  return key;
}

}  // namespace race::database
