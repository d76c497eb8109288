#include "server/mcp/schema.h"

#include <algorithm>

#include "core/value/error_list.h"
#include "core/value/fields.h"
#include "core/value/json.h"

namespace race::server::mcp {
namespace {

bool is_of_type(const Value& value, std::string_view type) {
  switch (value.kind()) {
    case Value::Kind::boolean:
      return type == "boolean";
    case Value::Kind::integer:
      return type == "integer" || type == "number";
    case Value::Kind::number:
      return type == "number";
    case Value::Kind::string:
      return type == "string";
    case Value::Kind::list:
      return type == "array";
    case Value::Kind::dict:
      return type == "object";
    case Value::Kind::null:
    case Value::Kind::unknown:
      return false;
  }
  return false;
}

void check_object(const Value& schema, const Dict& fields, const std::string& path, std::vector<Error>& errors) {
  const Value* properties = schema.find("properties");
  const Value* required = schema.find("required");
  for (const Value& name : required ? required->as_list() : List())
    if (!fields.find(name))
      add_error(errors, {ErrorCode::missing, "the field is missing", path + '/' + name.as_string()});
  for (const auto& [name, value] : fields) {
    const std::string below = path + '/' + name.as_string();
    const Value* property = properties ? properties->find(name.as_string()) : nullptr;
    if (property) {
      for (Error& error : violations(*property, value, below)) add_error(errors, std::move(error));
    } else if (schema.find("additionalProperties")) {
      add_error(errors, {ErrorCode::unknown_field, "there is no such field", below});
    }
  }
}

void check_limits(const Value& schema, const Value& value, const std::string& path, std::vector<Error>& errors) {
  const Value* least = schema.find("minimum");
  const Value* most = schema.find("maximum");
  const Value* length = schema.find("minLength");
  const Value* words = schema.find("enum");
  if (least && value.to_double() < least->to_double())
    add_error(errors, {ErrorCode::out_of_range, "must be at least " + to_json(*least), path});
  if (most && value.to_double() > most->to_double())
    add_error(errors, {ErrorCode::out_of_range, "must be at most " + to_json(*most), path});
  if (length && std::ssize(value.as_string()) < length->as_integer())
    add_error(errors, {ErrorCode::out_of_range, "must not be empty", path});
  if (words && std::ranges::find(words->as_list(), value) == words->as_list().end())
    add_error(errors, {ErrorCode::out_of_range, "must be one of " + to_json(*words), path});
}

}  // namespace

std::vector<Error> violations(const Value& schema, const Value& value, const std::string& path) {
  std::vector<Error> errors;
  const Value* type = schema.find("type");
  if (type && !is_of_type(value, type->as_string())) {
    add_error(errors, {ErrorCode::type,
                       "must be of type " + type->as_string() + ", got " + std::string(kind_name(value)), path});
    return errors;
  }
  if (value.is_dict()) check_object(schema, value.as_dict(), path, errors);
  check_limits(schema, value, path, errors);
  return errors;
}

}  // namespace race::server::mcp
