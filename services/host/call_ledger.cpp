#include "services/host/call_ledger.h"

#include <utility>

namespace race::services {

CallLedger::Violations CallLedger::call(const PendingCall& call, const List& args, const Dict& kwargs) {
  pending_.emplace(call.id, call);
  pending_units_ += call.units;
  if (!call.caller.core.empty()) awaited_.insert_or_assign(call.caller, call.id);
  return add(call.time, monitor_.called(call.id, call.operation, args, kwargs));
}

CallLedger::Violations CallLedger::transition(Time now, std::string_view id, CallId call) {
  Violations found = add(now, monitor_.transition(id, call));
  take(monitor_.superseded());
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
  auto found = pending_.extract(call);
  if (!found) return std::nullopt;
  PendingCall& taken = found.mapped();
  pending_units_ -= taken.units;
  const auto awaited = awaited_.find(taken.caller);
  if (awaited != awaited_.end() && awaited->second == call) awaited_.erase(awaited);
  return std::move(taken);
}

CallId CallLedger::abandon(const Caller& caller) {
  const auto found = awaited_.extract(caller);
  return found ? found.mapped() : 0;
}

std::vector<CallId> CallLedger::abandon_all(const std::string& core) {
  const auto first = awaited_.lower_bound({core, 0});
  auto last = first;
  std::vector<CallId> abandoned;
  for (; last != awaited_.end() && last->first.core == core; ++last) abandoned.push_back(last->second);
  awaited_.erase(first, last);
  return abandoned;
}

CallLedger::PendingCalls CallLedger::reset() {
  monitor_.restarted();
  awaited_.clear();
  pending_units_ = 0;
  return std::exchange(pending_, {});
}

std::string CallLedger::operation_of(CallId call) const {
  const auto found = pending_.find(call);
  return found == pending_.end() ? std::string() : found->second.operation;
}

}  // namespace race::services
