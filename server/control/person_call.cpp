#include "server/control/person_call.h"

#include <utility>

#include "services/component.h"

namespace race::server {

PersonCall read_call(std::string service, Fields& fields) {
  PersonCall call{std::move(service), fields.text("operation", Fields::Need::required).value_or("")};
  call.args = fields.list("args");
  const Value* given = fields.find("kwargs");
  if (given && given->is_dict())
    call.kwargs = given->as_dict();
  else if (given)
    fields.violation(ErrorCode::type, "`kwargs` must be an object", "kwargs");
  return call;
}

Dict response_json(const services::Delivery& delivery) {
  if (delivery.units > PersonCall::kMostUnits)
    return response_json(Error{ErrorCode::too_large, "the response is too large to be shown"});
  return Dict{{delivery.is_error ? "error" : "result", delivery.data}};
}

Dict response_json(const Error& refused) {
  return Dict{{"error", services::error_value(name(refused.code), refused.message)}};
}

bool PersonCalls::add(std::uint64_t number, Respond respond) {
  return calls_.size() < kMost && calls_.emplace(number, std::move(respond)).second;
}

std::optional<PersonCalls::Respond> PersonCalls::take(std::uint64_t number) {
  auto call = calls_.extract(number);
  if (!call) return std::nullopt;
  return std::move(call.mapped());
}

}  // namespace race::server
