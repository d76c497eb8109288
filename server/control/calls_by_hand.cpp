// Calls of operations by people: of who has the controls, on their connection, and by requests.
#include <algorithm>

#include "server/control/manual_control.h"

namespace race::server {

using services::MutexLock;

Expected<std::uint64_t> ManualControl::wait(Via via, PersonCalls::Respond respond) {
  const bool is_request = via == Via::request;
  if ((is_request ? by_request_ : holder_->calls).add(last_call_ + 1, std::move(respond))) return ++last_call_;
  return unexpected(is_request ? ErrorCode::unavailable : ErrorCode::too_large,
                    std::to_string(PersonCalls::kMost) + " calls wait for their responses");
}

Expected<ManualControl::ByHand> ManualControl::begin_by_hand(std::uint64_t control, const PersonCall& call, Steady now,
                                                             Via via, PersonCalls::Respond respond) {
  ASSIGN_OR_RETURN(const std::uint64_t fence, control_.fence_of(control));
  const bool is_held = host_.is_held(call.service, call.operation);
  const MutexLock lock(mutex_);
  if (!holder_ || holder_->number != control)
    return unexpected(ErrorCode::leased, "you have not the controls of the cell any more");
  if (is_held && holder_->held.is_held_over(call.service, fence, now))
    return unexpected(ErrorCode::stopped, "the cell was stopped meanwhile: let the button go first");
  ASSIGN_OR_RETURN(const std::uint64_t number, wait(via, std::move(respond)));
  return ByHand{{Control::caller(control), number, fence}, holder_->begins(call, is_held, now)};
}

// A call is a sign of life, too.
void ManualControl::call(Fields& fields, const Message& message) {
  const auto number = fields.integer("number", 0, std::int64_t{1} << 53U, Fields::Need::required);
  auto service = fields.text("service", Fields::Need::required);
  const PersonCall call = read_call(std::move(service).value_or(""), fields);
  fields.close();
  if (!message.errors.empty()) return;
  const auto respond = [number = *number, weak = std::weak_ptr(message.client)](Dict response) {
    response.set("kind", "response");
    response.set("number", number);
    if (const auto client = weak.lock()) client->tell(Value(std::move(response)).freeze());
  };
  const std::uint64_t control = number_of(*message.client);
  if (!control_.hear(control, message.now))
    return respond(response_json(Error{ErrorCode::leased, "take the controls of the cell first"}));
  const auto begun = begin_by_hand(control, call, message.now, Via::connection, respond);
  if (!begun) return respond(response_json(begun.error()));
  if (begun->is_new)
    record_(message.client->identity(), "control call " + call.service + '.' + call.operation, "accepted");
  host_.call(begun->caller, call.service, call.operation, call.args, call.kwargs);
}

Expected<ManualControl::Effect> ManualControl::effect_of(const PersonCall& call) const {
  const auto service = host_.service(call.service);
  if (!service || !service->model)
    return unexpected(ErrorCode::not_found, "there is no service of this key", call.service);
  const auto& operations = service->model->operations;
  const auto operation = std::ranges::find(operations, call.operation, &rsm::Operation::name);
  if (operation == operations.end()) return Effect{};
  return Effect{operation->moves, !operation->reads && !operation->safe};
}

// What a run reads or asks next may be changed by that, and so what it moves.
Expected<void> ManualControl::may_call(const Sender& sender, const PersonCall& call, const Effect& effect) const {
  if (sender.control != 0) return {};
  if (effect.moves)
    return unexpected(ErrorCode::leased, "take the controls of the cell first: " + quote(call.operation) + " moves");
  if (effect.changes && control_.holder() != 0)
    return unexpected(ErrorCode::leased, "somebody has the controls of the cell, and alone changes something in it");
  return {};
}

Expected<services::Caller> ManualControl::begin_free(PersonCalls::Respond respond) {
  const MutexLock lock(mutex_);
  ASSIGN_OR_RETURN(const std::uint64_t number, wait(Via::request, std::move(respond)));
  return services::Caller{std::string(kRequests), number, 0};
}

Expected<services::Caller> ManualControl::call_by_request(const Sender& sender, const PersonCall& call,
                                                          PersonCalls::Respond respond) {
  ASSIGN_OR_RETURN(const Effect effect, effect_of(call));
  if (auto may = may_call(sender, call, effect); !may) return tl::unexpected(std::move(may).error());
  ByHand begun{{}, effect.changes};
  if (sender.control == 0) {
    ASSIGN_OR_RETURN(begun.caller, begin_free(std::move(respond)));
  } else {
    ASSIGN_OR_RETURN(
        begun, begin_by_hand(sender.control, call, std::chrono::steady_clock::now(), Via::request, std::move(respond)));
  }
  if (begun.is_new && effect.changes)
    record_(sender.identity, "service call " + call.service + '.' + call.operation, "accepted");
  host_.call(begun.caller, call.service, call.operation, call.args, call.kwargs);
  return begun.caller;
}

bool ManualControl::give_up(const services::Caller& caller) {
  {
    const MutexLock lock(mutex_);
    if (!by_request_.take(caller.call)) return false;
  }
  host_.abandon(caller);
  return true;
}

// Numbers are of one count: a response is for one of the two alone.
void ManualControl::delivered(const services::Delivery& delivery) {
  const std::string& caller = delivery.caller.core;
  if (delivery.kind != services::Delivery::Kind::response || (caller != kRequests && !Control::is_person(caller)))
    return;
  std::optional<PersonCalls::Respond> respond;
  {
    const MutexLock lock(mutex_);
    respond = by_request_.take(delivery.caller.call);
    if (!respond && holder_ && caller == Control::caller(holder_->number))
      respond = holder_->calls.take(delivery.caller.call);
  }
  if (respond) (*respond)(response_json(delivery));
}

}  // namespace race::server
