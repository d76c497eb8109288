// Evaluation of service data: events, responses, and what is available.
#include "core/language/evaluate/machine_internal.h"

namespace race::language {

void Machine::require(EventId event) {
  if (environment_->trace != nullptr) environment_->trace->required_event(event);
}

// svc.S.ev as data: of the occurrence in this macro step; of a sampled event the newest sample ever delivered (R5).
const Value& Machine::event(EventId event, NodeId id) {
  require(event);
  const bool known = environment_->sampled[event] != 0 || environment_->occurrence == event;
  if (!known) return unknown(id);
  const Value& data = environment_->event_data[event];
  return data.is_unknown() ? unknown(id) : data;
}

// svc.S.ev in a boolean position: an occurrence in this macro step, of sampled events too (R2, R5).
const Value& Machine::event_present(EventId event, NodeId id) {
  require(event);
  return environment_->occurrence == event ? kTrue : unknown(id);
}

const Value& Machine::latest(EventId event, NodeId id) {
  require(event);
  const Value& data = environment_->event_data[event];
  return data.is_unknown() ? unknown(id) : data;
}

const Value& Machine::response(OperationId operation, std::string_view service, bool error, bool presence, NodeId id) {
  if (environment_->trace != nullptr) environment_->trace->required_response(operation, service, error);
  const Value& data = environment_->response(operation, service, error);
  if (data.is_unknown()) return unknown(id);
  return presence ? kTrue : data;
}

// svc[e].ev; an unknown service or event is missing data.
const Value& Machine::dynamic_event(const Node& n, NodeId id) {
  Value out;
  const Value& service = evaluate(n.a, out);
  if (service.is_unknown()) return kUnknown;
  if (!service.is_string()) return fail(FaultKind::type, "the name of a service must be str", id);
  const EventId found = environment_->services().find_event(service.as_string(), constants_[n.b].as_string());
  if (found == kNone) return unknown(id);
  switch (static_cast<DynamicRead>(n.c)) {
    case DynamicRead::present:
      return event_present(found, id);
    case DynamicRead::latest:
      return latest(found, id);
    default:
      return event(found, id);
  }
}

const Value& Machine::dynamic_response(const Node& n, NodeId id) {
  Value out;
  const Value& service = evaluate(n.a, out);
  if (service.is_unknown()) return kUnknown;
  if (!service.is_string()) return fail(FaultKind::type, "the name of a service must be str", id);
  const OperationId found =
      environment_->services().dynamic_operation(service.as_string(), constants_[n.b].as_string());
  const std::string_view whose = environment_->services().is_open(found) ? service.as_string() : std::string_view();
  return response(found, whose, (n.c & 1) != 0, (n.c & 2) != 0, id);
}

// available(x): whether x is known; the one place where a function may meet something unknown.
const Value& Machine::available(const Node& n, Value& out) {
  const bool strict = strict_;
  strict_ = false;
  const Value& v = evaluate(n.a, out);
  strict_ = strict;
  if (stopped_) return kUnknown;
  return v.is_unknown() ? kFalse : kTrue;
}

}  // namespace race::language
