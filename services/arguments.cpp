#include "services/arguments.h"

#include <algorithm>
#include <charconv>

#include "core/rsm/type.h"

namespace race::services {
namespace {

std::string text(double limit) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, limit).ptr};
}

tl::unexpected<Error> refuse(ErrorCode code, const rsm::OperationParameter& parameter, const std::string& why) {
  return unexpected(code, "argument `" + parameter.name + "`: " + why, parameter.name);
}

Expected<void> check(const rsm::OperationParameter& parameter, const Value& value) {
  if (const auto why = rsm::mismatch(parameter.type, value)) return refuse(ErrorCode::type, parameter, *why);
  if (!value.is_numeric()) return {};
  const double number = value.to_double();
  if (parameter.min && !(number >= *parameter.min))
    return refuse(ErrorCode::out_of_range, parameter,
                  "must be at least " + text(*parameter.min) + ", got " + text(number));
  if (parameter.max && !(number <= *parameter.max))
    return refuse(ErrorCode::out_of_range, parameter,
                  "must be at most " + text(*parameter.max) + ", got " + text(number));
  return {};
}

}  // namespace

Expected<Dict> bind_arguments(const rsm::Operation& operation, const Call& call) {
  const auto& parameters = operation.parameters;
  if (call.args.size() > parameters.size())
    return unexpected(ErrorCode::type, "`" + operation.name + "` takes at most " + std::to_string(parameters.size()) +
                                           " arguments, got " + std::to_string(call.args.size()));
  for (const auto& [key, value] : call.kwargs) {
    const auto found =
        std::find_if(parameters.begin(), parameters.end(), [&](const auto& p) { return p.name == key.as_string(); });
    if (found == parameters.end())
      return unexpected(ErrorCode::type, "`" + operation.name + "` has no parameter `" + key.as_string() + "`");
    if (static_cast<std::size_t>(found - parameters.begin()) < call.args.size())
      return refuse(ErrorCode::type, *found, "is given twice");
  }
  Dict bound;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const rsm::OperationParameter& parameter = parameters[i];
    const Value* given = i < call.args.size() ? &call.args[i] : call.kwargs.find(parameter.name);
    if (!given && parameter.value) given = &*parameter.value;
    if (!given && parameter.type.find("optional")) continue;
    if (!given) return refuse(ErrorCode::missing, parameter, "is missing");
    if (auto fits = check(parameter, *given); !fits) return tl::unexpected(std::move(fits).error());
    bound.set(parameter.name, *given);
  }
  return bound;
}

const rsm::Operation* find_operation(const rsm::Service& service, std::string_view name) {
  for (const rsm::Operation& operation : service.operations)
    if (operation.name == name) return &operation;
  return nullptr;
}

Value error_value(const Error& error) { return error_value(name(error.code), error.message); }

}  // namespace race::services
