#include "services/host/call_ledger.h"

#include <algorithm>
#include <utility>

namespace race::services {

CallLedger::Violations CallLedger::call(const PendingCall& call, const List& args, const Dict& kwargs) {
  pending_.push_back(call);
  if (!call.caller.core.empty()) awaited_.insert_or_assign(call.caller, call.id);
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
  const auto found = find(call);
  if (found == pending_.end()) return std::nullopt;
  PendingCall taken = *found;
  pending_.erase(found);
  forget_caller(taken);
  return taken;
}

bool CallLedger::is_pending(CallId call) const { return find(call) != pending_.end(); }

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

std::vector<PendingCall> CallLedger::reset() {
  monitor_.restarted();
  awaited_.clear();
  return std::exchange(pending_, {});
}

// Ids of calls grow.
std::vector<PendingCall>::const_iterator CallLedger::find(CallId call) const {
  const auto found = std::ranges::lower_bound(pending_, call, {}, &PendingCall::id);
  return found != pending_.end() && found->id == call ? found : pending_.end();
}

std::string CallLedger::operation_of(CallId call) const {
  const auto found = find(call);
  return found == pending_.end() ? std::string() : found->operation;
}

void CallLedger::forget_caller(const PendingCall& call) {
  const auto found = awaited_.find(call.caller);
  if (found != awaited_.end() && found->second == call.id) awaited_.erase(found);
}

// OPTIMIZATION: what is open for the monitor is pending, so that as many are the same.
void CallLedger::drop_superseded() {
  if (monitor_.open_count() == pending_.size()) return;
  std::erase_if(pending_, [&](const PendingCall& each) {
    if (monitor_.is_open(each.id)) return false;
    forget_caller(each);
    return true;
  });
}

}  // namespace race::services
