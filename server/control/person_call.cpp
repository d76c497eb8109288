#include "server/control/person_call.h"

#include <algorithm>
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

PersonCalls::Place PersonCalls::place_of(rsm::CallEffect effect) {
  if (effect == rsm::CallEffect::none) return Place::reads;
  return effect == rsm::CallEffect::stop ? Place::stops : Place::others;
}

Expected<void> PersonCalls::may_wait(Place place, std::string_view account) const {
  const auto is_there = [&](const auto& call) { return call.second.place == place; };
  const auto is_of_account = [&](const auto& call) { return is_there(call) && call.second.account == account; };
  if (!account.empty() && std::cmp_greater_equal(std::ranges::count_if(calls_, is_of_account), kMostOfAccount))
    return unexpected(ErrorCode::too_large,
                      std::to_string(kMostOfAccount) + " calls of the account wait for their responses");
  if (std::cmp_greater_equal(std::ranges::count_if(calls_, is_there), kMost))
    return unexpected(ErrorCode::unavailable, std::to_string(kMost) + " calls wait for their responses");
  return {};
}

std::optional<PersonCalls::Waiting> PersonCalls::take(std::uint64_t number) {
  auto call = calls_.extract(number);
  if (!call) return std::nullopt;
  return std::move(call.mapped());
}

}  // namespace race::server
