#include "core/execution/input_fields.h"

#include <string>

#include "core/value/json.h"

namespace race::execution {

using semantics::Force;

std::optional<Value> read_data(Fields& fields, std::string_view key) {
  constexpr std::size_t kLevels = JsonLimits{}.depth;
  auto data = fields.constant(key, kRequired);
  if (!data) return std::nullopt;
  if (deeper_than(*data, kLevels)) {
    fields.violation(ErrorCode::too_deep, "more than " + std::to_string(kLevels) + " levels of nesting", key);
    return std::nullopt;
  }
  data->freeze();
  return data;
}

Force read_force(Fields& fields) {
  Force force;
  force.path = fields.text("path", kRequired).value_or("");
  force.name = fields.text("name", kRequired).value_or("");
  const auto text = fields.text("scope", kRequired);
  const auto scope = semantics::force_scope(text.value_or(""));
  if (text && !scope) fields.violation(ErrorCode::type, "`scope` must be `par`, `res`, `var` or `port`", "scope");
  force.scope = scope.value_or(Force::Scope::port);
  if (force.scope != Force::Scope::port)
    force.value = read_data(fields, "value").value_or(Value());
  else if (fields.find("value") && scope)
    fields.violation(ErrorCode::unknown_field, "a port has no value", "value");
  return force;
}

}  // namespace race::execution
