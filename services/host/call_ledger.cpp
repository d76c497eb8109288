#include "services/host/call_ledger.h"

#include <algorithm>
#include <utility>

namespace race::services {

CallLedger::Violations CallLedger::call(const PendingCall& call, const List& args, const Dict& kwargs) {
  pending_.push_back(call);
  return add(call.time, monitor_.called(call.id, call.operation, args, kwargs));
}

CallLedger::Violations CallLedger::transition(Time now, std::string_view id, CallId call) {
  Violations found = add(now, monitor_.transition(id, call));
  drop_superseded();
  return found;
}

CallLedger::Violations CallLedger::reject(Time now, CallId call) { return add(now, monitor_.rejected(call)); }

CallLedger::Violations CallLedger::respond(Time now, CallId call, const Value& value, bool is_error) {
  return add(now, is_error ? monitor_.error(call, value) : monitor_.result(call, value));
}

CallLedger::Violations CallLedger::event(Time now, std::string_view name, const Value& data) {
  return add(now, monitor_.event(name, data));
}

CallLedger::Violations CallLedger::add(Time now, const rsm::Monitor::Violations& found) {
  Violations added;
  for (const rsm::Violation& each : found)
    added.push_back({now, each.rule, each.message, each.call, operation_of(each.call)});
  violations_.insert(violations_.end(), added.begin(), added.end());
  if (violations_.size() > kViolationsKept) violations_.erase(violations_.begin(), violations_.end() - kViolationsKept);
  return added;
}

std::optional<PendingCall> CallLedger::take(CallId call) {
  const auto found = std::ranges::find(pending_, call, &PendingCall::id);
  if (found == pending_.end()) return std::nullopt;
  PendingCall taken = std::move(*found);
  pending_.erase(found);
  return taken;
}

std::vector<PendingCall> CallLedger::reset() {
  monitor_.restarted();
  return std::exchange(pending_, {});
}

std::string CallLedger::operation_of(CallId call) const {
  const auto found = std::ranges::find(pending_, call, &PendingCall::id);
  return found == pending_.end() ? std::string() : found->operation;
}

void CallLedger::drop_superseded() {
  const auto open = monitor_.open_calls();
  std::erase_if(pending_, [&](const PendingCall& each) { return std::ranges::find(open, each.id) == open.end(); });
}

}  // namespace race::services
