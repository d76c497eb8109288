#include "core/rsm/document.h"

#include "core/rsm/type.h"
#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::rsm {
namespace {

using Need = Fields::Need;
using Errors = std::vector<Error>;

std::string element(std::string_view what, const Value& json, std::string_view key) {
  const Value* name = json.find(key);
  return std::string(what) + (name && name->is_string() ? " `" + name->as_string() + "`" : "");
}

/// A required name; that it is missing or empty is reported here alone.
std::string read_name(Fields& fields, std::string_view key) {
  const auto name = fields.text(key, Need::required);
  if (name && name->empty()) fields.violation(ErrorCode::name, "`" + std::string(key) + "` is empty");
  return name.value_or("");
}

Value read_type(Fields& fields, std::string_view key) {
  const Value* type = fields.find(key);
  if (!type) return Value();
  const auto reason = malformed(*type);
  if (!reason) return *type;
  fields.violation(ErrorCode::type, "`" + std::string(key) + "`: " + *reason);
  return Value();
}

OperationParameter read_parameter(const Value& json, const std::string& owner, Fields& parent, Errors& errors) {
  Fields fields(json, parent.path(), owner + ", " + element("parameter", json, "name"), errors);
  OperationParameter out;
  out.name = read_name(fields, "name");
  out.type = read_type(fields, "type");
  out.unit = fields.text("unit").value_or("");
  out.min = fields.number("min");
  out.max = fields.number("max");
  out.value = fields.constant("value");
  out.doc = fields.text("doc").value_or("");
  fields.close();
  return out;
}

Operation read_operation(const Value& json, Fields& parent, Errors& errors) {
  const std::string what = element("operation", json, "name");
  Fields fields(json, parent.path(), what, errors);
  Operation out;
  out.name = read_name(fields, "name");
  for (const Value& item : fields.list("parameters"))
    out.parameters.push_back(read_parameter(item, what, fields, errors));
  out.result = read_type(fields, "result");
  out.error = read_type(fields, "error");
  out.safe = fields.boolean("safe").value_or(false);
  out.moves = fields.boolean("moves").value_or(false);
  out.held = fields.boolean("held").value_or(false);
  out.paces = fields.boolean("paces").value_or(false);
  out.reads = fields.boolean("reads").value_or(false);
  out.doc = fields.text("doc").value_or("");
  fields.close();
  return out;
}

Event read_event(const Value& json, Fields& parent, Errors& errors) {
  Fields fields(json, parent.path(), element("event", json, "name"), errors);
  Event out;
  out.name = read_name(fields, "name");
  out.data = read_type(fields, "data");
  out.sampled = fields.boolean("sampled").value_or(false);
  out.rate_hz = fields.number("rate_hz");
  out.doc = fields.text("doc").value_or("");
  fields.close();
  return out;
}

Uses read_uses(const Value& json, std::string_view list, std::string_view key, Fields& parent, Errors& errors) {
  Fields fields(json, parent.path(), "an item of `" + std::string(list) + "`", errors);
  Uses out;
  out.service = read_name(fields, "service");
  out.name = read_name(fields, key);
  fields.close();
  return out;
}

ServiceState read_state(const Value& json, Fields& parent, Errors& errors) {
  Fields fields(json, parent.path(), element("state", json, "name"), errors);
  ServiceState out;
  out.name = read_name(fields, "name");
  out.events = fields.texts("events");
  fields.close();
  return out;
}

Transition read_transition(const Value& json, Fields& parent, Errors& errors) {
  Fields fields(json, parent.path(), element("transition", json, "id"), errors);
  Transition out;
  out.id = read_name(fields, "id");
  out.src = fields.text("src");
  out.dst = read_name(fields, "dst");
  out.operation = fields.text("operation");
  out.events = fields.texts("events");
  out.defer = fields.texts("defer");
  out.error = fields.text("error");
  out.concurrent = fields.boolean("concurrent").value_or(false);
  fields.close();
  return out;
}

Service read_fields(const Value& json, const std::string& path, Errors& errors) {
  Fields fields(json, path, element("service", json, "name"), errors);
  Service out;
  const Value* version = fields.find("rsm");
  if (version && *version != Value(1)) fields.violation(ErrorCode::version, "`rsm` must be 1");
  out.name = fields.text("name").value_or("");
  for (const Value& item : fields.list("operations")) out.operations.push_back(read_operation(item, fields, errors));
  for (const Value& item : fields.list("events")) out.events.push_back(read_event(item, fields, errors));
  for (const Value& item : fields.list("subscribes"))
    out.subscribes.push_back(read_uses(item, "subscribes", "event", fields, errors));
  for (const Value& item : fields.list("calls"))
    out.calls.push_back(read_uses(item, "calls", "operation", fields, errors));
  for (const Value& item : fields.list("states")) out.states.push_back(read_state(item, fields, errors));
  out.init = fields.text("init").value_or("");
  for (const Value& item : fields.list("transitions")) out.transitions.push_back(read_transition(item, fields, errors));
  out.meta = fields.constant("meta").value_or(Value());
  fields.close();
  return out;
}

/// Builds an object, leaving out what is empty.
class Writer {
 public:
  void set(std::string_view key, Value value) { out_.set(key, std::move(value)); }
  void text(std::string_view key, const std::string& value) {
    if (!value.empty()) set(key, value);
  }
  void text(std::string_view key, const std::optional<std::string>& value) {
    if (value) set(key, *value);
  }
  void number(std::string_view key, const std::optional<double>& value) {
    if (value) set(key, *value);
  }
  void json(std::string_view key, const Value& value) {
    if (!value.is_null()) set(key, value);
  }
  void flag(std::string_view key, bool value) {
    if (value) set(key, true);
  }
  void texts(std::string_view key, const std::vector<std::string>& items) {
    if (!items.empty()) set(key, List(items.begin(), items.end()));
  }
  template <typename T, typename F>
  void list(std::string_view key, const std::vector<T>& items, F write) {
    if (items.empty()) return;
    List out;
    for (const T& item : items) out.push_back(write(item));
    set(key, std::move(out));
  }
  Value done() { return Value(std::move(out_)); }

 private:
  Dict out_;
};

Value write_parameter(const OperationParameter& parameter) {
  Writer out;
  out.set("name", parameter.name);
  out.json("type", parameter.type);
  out.text("unit", parameter.unit);
  out.number("min", parameter.min);
  out.number("max", parameter.max);
  if (parameter.value) out.set("value", *parameter.value);
  out.text("doc", parameter.doc);
  return out.done();
}

Value write_operation(const Operation& operation) {
  Writer out;
  out.set("name", operation.name);
  out.list("parameters", operation.parameters, write_parameter);
  out.json("result", operation.result);
  out.json("error", operation.error);
  out.flag("safe", operation.safe);
  out.flag("moves", operation.moves);
  out.flag("held", operation.held);
  out.flag("paces", operation.paces);
  out.flag("reads", operation.reads);
  out.text("doc", operation.doc);
  return out.done();
}

Value write_event(const Event& event) {
  Writer out;
  out.set("name", event.name);
  out.json("data", event.data);
  out.flag("sampled", event.sampled);
  out.number("rate_hz", event.rate_hz);
  out.text("doc", event.doc);
  return out.done();
}

Value write_state(const ServiceState& state) {
  Writer out;
  out.set("name", state.name);
  out.texts("events", state.events);
  return out.done();
}

Value write_transition(const Transition& transition) {
  Writer out;
  out.set("id", transition.id);
  out.text("src", transition.src);
  out.set("dst", transition.dst);
  out.text("operation", transition.operation);
  out.texts("events", transition.events);
  out.texts("defer", transition.defer);
  out.text("error", transition.error);
  if (transition.concurrent) out.set("concurrent", true);
  return out.done();
}

}  // namespace

Checked<Service> read_service(const Value& json, const std::string& path) {
  Errors errors;
  Service out = read_fields(json, path, errors);
  if (json.is_dict()) {
    append_below(errors, violations(out, path), "");
  }
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return out;
}

Checked<Service> read_service_text(std::string_view text, const std::string& path) {
  auto json = parse_json(text, JsonLimits{.keep_out_of_range = true});
  if (json) return read_service(*json, path);
  Error error = std::move(json).error();
  error.path = path;
  return tl::unexpected(Errors{std::move(error)});
}

Value write_service(const Service& service) {
  const auto write_uses = [](std::string_view key) {
    return [key](const Uses& uses) { return Value(Dict{{"service", uses.service}, {key, uses.name}}); };
  };
  Writer out;
  out.set("rsm", 1);
  out.text("name", service.name);
  out.set("operations", List());
  out.list("operations", service.operations, write_operation);
  out.set("events", List());
  out.list("events", service.events, write_event);
  out.list("subscribes", service.subscribes, write_uses("event"));
  out.list("calls", service.calls, write_uses("operation"));
  out.list("states", service.states, write_state);
  out.text("init", service.init);
  out.list("transitions", service.transitions, write_transition);
  out.json("meta", service.meta);
  return out.done();
}

}  // namespace race::rsm
