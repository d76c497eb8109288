// Calls of operations by people: of who has the controls, on their connection, and by requests.
#include "server/control/manual_control.h"

namespace race::server {

using services::MutexLock;

Expected<services::Caller> ManualControl::wait(services::Caller caller, Wanted wanted) {
  PersonCalls::Waiting waiting{std::move(wanted.respond), wanted.place, wanted.by_request.value_or("")};
  PersonCalls& calls = wanted.by_request ? by_request_ : holder_->calls;
  if (auto may = calls.may_wait(waiting.place, waiting.account); !may)
    return wanted.by_request ? tl::unexpected(std::move(may).error())
                             : unexpected(ErrorCode::too_large, may.error().message);
  caller.call = ++last_call_;
  if (wanted.by_request) waiting.deadline = deadlines_.after(kResponseTime, [this, caller] { give_up(caller); });
  calls.add(caller.call, std::move(waiting));
  return caller;
}

Expected<ManualControl::ByHand> ManualControl::begin_by_hand(std::uint64_t control, const PersonCall& call, Steady now,
                                                             Wanted wanted) {
  ASSIGN_OR_RETURN(const std::uint64_t fence, control_.fence_of(control));
  const bool is_held = host_.is_held(call.service, call.operation);
  const MutexLock lock(mutex_);
  if (!holder_ || holder_->number != control)
    return unexpected(ErrorCode::leased, "you have not the controls of the cell any more");
  if (is_held && holder_->held.is_held_over(call.service, fence, now))
    return unexpected(ErrorCode::stopped, "it was stopped meanwhile: let the button go, and press it again");
  ASSIGN_OR_RETURN(services::Caller caller, wait({Control::caller(control), 0, fence}, std::move(wanted)));
  return ByHand{std::move(caller), holder_->begins(call, is_held, now)};
}

// A call is a sign of life, too.
void ManualControl::call(Fields& fields, const Message& message) {
  const auto number = fields.integer("number", 0, std::int64_t{1} << 53U, Fields::Need::required);
  auto service = fields.text("service", Fields::Need::required);
  const PersonCall call = read_call(std::move(service).value_or(""), fields);
  fields.close();
  if (!message.errors.empty()) return;
  const auto respond = [number = *number, weak = std::weak_ptr(message.client)](const Expected<Dict>& response) {
    Dict json = response ? *response : response_json(response.error());
    json.set("kind", "response");
    json.set("number", number);
    if (const auto client = weak.lock()) client->tell(Value(std::move(json)).freeze());
  };
  const std::uint64_t control = number_of(*message.client);
  if (!control_.hear(control, message.now))
    return respond(unexpected(ErrorCode::leased, "take the controls of the cell first"));
  const auto effect = host_.effect_of(call.service, call.operation).value_or(rsm::CallEffect::none);
  const auto begun = begin_by_hand(control, call, message.now, {respond, PersonCalls::place_of(effect)});
  if (!begun) return respond(tl::unexpected(begun.error()));
  if (begun->is_new)
    record_(message.client->identity(), "control call " + call.service + '.' + call.operation, "accepted");
  host_.call(begun->caller, call.service, call.operation, call.args, call.kwargs);
}

// What a run reads or asks next may be changed by that, and so what it moves.
Expected<void> ManualControl::may_call(const Sender& sender, const PersonCall& call, rsm::CallEffect effect) const {
  if (sender.control != 0) return {};
  if (rsm::moves(effect))
    return unexpected(ErrorCode::leased, "take the controls of the cell first: " + quote(call.operation) + " moves");
  if (effect == rsm::CallEffect::change && control_.holder() != 0)
    return unexpected(ErrorCode::leased, "somebody has the controls of the cell, and alone changes something in it");
  return {};
}

Expected<services::Caller> ManualControl::begin_free(Wanted wanted) {
  const MutexLock lock(mutex_);
  return wait({std::string(kRequests), 0, 0}, std::move(wanted));
}

void ManualControl::end_by_hand(const std::string& service) {
  const MutexLock lock(mutex_);
  control_.end_by_hand(service, last_call_);
  if (holder_) holder_->held.end(service);
}

Expected<void> ManualControl::call_by_request(const Sender& sender, const PersonCall& call,
                                              PersonCalls::Respond respond) {
  ASSIGN_OR_RETURN(const rsm::CallEffect effect, host_.effect_of(call.service, call.operation));
  if (auto may = may_call(sender, call, effect); !may) return tl::unexpected(std::move(may).error());
  const bool changes = effect != rsm::CallEffect::none;
  ByHand begun{{}, changes};
  Wanted wanted{std::move(respond), PersonCalls::place_of(effect), sender.identity.account};
  if (sender.control == 0) {
    ASSIGN_OR_RETURN(begun.caller, begin_free(std::move(wanted)));
  } else {
    ASSIGN_OR_RETURN(begun, begin_by_hand(sender.control, call, std::chrono::steady_clock::now(), std::move(wanted)));
  }
  const bool stops = effect == rsm::CallEffect::stop;
  if (stops) end_by_hand(call.service);
  if (changes && (begun.is_new || stops))
    record_(sender.identity, "service call " + call.service + '.' + call.operation, "accepted");
  host_.call(begun.caller, call.service, call.operation, call.args, call.kwargs);
  return {};
}

void ManualControl::give_up(const services::Caller& caller) {
  std::optional<PersonCalls::Waiting> late;
  {
    const MutexLock lock(mutex_);
    late = by_request_.take(caller.call);
  }
  if (!late) return;
  host_.abandon(caller);
  late->respond(unexpected(ErrorCode::unavailable, "the service has not responded yet; what was called may be done"));
}

// Numbers are of one count: a response is for one of the two alone.
void ManualControl::delivered(const services::Delivery& delivery) {
  const std::string& caller = delivery.caller.core;
  if (delivery.kind != services::Delivery::Kind::response || (caller != kRequests && !Control::is_person(caller)))
    return;
  std::optional<PersonCalls::Waiting> waiting;
  {
    const MutexLock lock(mutex_);
    waiting = by_request_.take(delivery.caller.call);
    if (!waiting && holder_ && caller == Control::caller(holder_->number))
      waiting = holder_->calls.take(delivery.caller.call);
  }
  if (!waiting) return;
  deadlines_.drop(waiting->deadline);
  waiting->respond(response_json(delivery));
}

}  // namespace race::server
