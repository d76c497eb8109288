#include "server/wire/service_json.h"

#include "core/rsm/document.h"

namespace race::server {
namespace {

Value number(std::uint64_t n) { return static_cast<std::int64_t>(n); }

Value pending_json(const services::PendingCall& call) {
  Dict json{{"call", number(call.id)}, {"operation", call.operation}, {"time", call.time}};
  if (!call.caller.core.empty()) {
    json.set("core", call.caller.core);
    json.set("core_call", number(call.caller.call));
  }
  return json;
}

Value violation_json(const services::Violation& violation) {
  Dict json{{"time", violation.time}, {"rule", violation.rule}, {"message", violation.message}};
  if (violation.call != 0) json.set("call", number(violation.call));
  if (!violation.operation.empty()) json.set("operation", violation.operation);
  return json;
}

Value published_json(const services::Published& flow) {
  Dict json{{"flow", flow.flow}, {"watchers", number(flow.watchers)}, {"rate_hz", flow.rate_hz}};
  if (flow.last) json.set("last", Dict{{"time", flow.last->time}, {"header", flow.last->header}});
  return json;
}

}  // namespace

Value service_state_json(const services::ServiceStatus& status) {
  List pending, violations, publishes, subscribes;
  for (const auto& each : status.pending) pending.push_back(pending_json(each));
  for (const auto& each : status.violations) violations.push_back(violation_json(each));
  for (const auto& each : status.publishes) publishes.push_back(published_json(each));
  for (const auto& each : status.subscribes)
    subscribes.push_back(Dict{{"service", each.service}, {"flow", each.flow}, {"listening", each.listening}});
  Dict json{{"key", status.key},
            {"state", status.state ? Value(*status.state) : Value()},
            {"available", status.available},
            {"pending_count", number(status.pending_count)},
            {"pending", std::move(pending)},
            {"violations", std::move(violations)},
            {"publishes", std::move(publishes)},
            {"subscribes", std::move(subscribes)}};
  if (!status.last.empty()) json.set("last", status.last);
  return json;
}

Value services_json(const std::vector<services::ServiceStatus>& services) {
  List list;
  for (const services::ServiceStatus& status : services) {
    Dict service = service_state_json(status).as_dict();
    service.set("type", status.type);
    service.set("rsm", rsm::write_service(*status.model));
    list.emplace_back(std::move(service));
  }
  Value json = Dict{{"services", std::move(list)}};
  return std::move(json.freeze());
}

}  // namespace race::server
