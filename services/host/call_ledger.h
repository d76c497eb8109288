// CallLedger: the calls of one service that wait for a response, and a monitor that holds what the service announces
// against its RSM (R18). It keeps what does not fit and changes nothing else. What it does for one call takes no longer
// the more of them wait.
//
// Threads: one at a time, under the host's lock.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/rsm/monitor.h"
#include "services/component.h"

namespace race::services {

/// Who called: a core and its number of the call; no core: the server.
struct Caller {
  std::string core;
  std::uint64_t call = 0;
  std::uint64_t fence = 0;  // what the run has from MotionGate::begin(); names no caller
  auto operator<=>(const Caller& other) const { return std::tie(core, call) <=> std::tie(other.core, other.call); }
  bool operator==(const Caller& other) const { return core == other.core && call == other.call; }
};

struct PendingCall {
  CallId id = 0;
  std::string operation;
  Time time = 0;  // when it arrived
  Caller caller;
  std::size_t units = 0;  // of its arguments (Value::size_units)
};

/// What did not fit: the rule of the RSM, why, in which call (0: none).
struct Violation {
  Time time = 0;
  std::string rule, message;
  CallId call = 0;
  std::string operation;
};

class CallLedger {
 public:
  static constexpr std::size_t kViolationsKept = 100;
  // Calls of a service that wait, and the units of their arguments, but for the last: one that answers nothing takes no
  // more.
  static constexpr std::size_t kMostPending = 10'000;
  static constexpr std::size_t kMostPendingUnits = 32U << 20U;
  using Violations = std::vector<Violation>;
  using PendingCalls = std::map<CallId, PendingCall>;

  /// A service in its initial state, without calls.
  explicit CallLedger(const rsm::Service& model) : monitor_(model) {}

  // What happened at `now`. Each returns what does not fit.

  Violations call(const PendingCall& call, const List& args, const Dict& kwargs);
  /// A call that this one has superseded (R17) is pending no longer.
  Violations transition(Time now, std::string_view id, CallId call);
  Violations reject(Time now, CallId call);
  Violations respond(Time now, CallId call, const Value& value, bool is_error);
  Violations event(Time now, std::string_view name, const Value& data);
  /// What the host has found itself.
  Violations add(Time now, const rsm::Monitor::Violations& found);

  /// Removes a call that is pending: its response goes out now. Nothing: it has had one.
  std::optional<PendingCall> take(CallId call);
  bool is_pending(CallId call) const { return pending_.contains(call); }
  /// Whether as many calls wait as may.
  bool is_full() const { return pending_.size() >= kMostPending || pending_units_ > kMostPendingUnits; }

  // Nobody can receive the response to a call of a core any more: it stays pending until it has one, and is returned
  // once.

  /// The call that `caller` made; 0: it is not pending, or was abandoned before.
  CallId abandon(const Caller& caller);
  /// All calls of `core`, in the order of its numbers.
  std::vector<CallId> abandon_all(const std::string& core);

  /// The component is disconnected: returns what was pending, in order of call. The RSM is in its initial state again.
  PendingCalls reset();

  const PendingCalls& pending() const { return pending_; }
  /// The last kViolationsKept.
  const Violations& violations() const { return violations_; }
  /// Empty for a mere interface.
  const std::string& state() const { return monitor_.current(); }

 private:
  std::string operation_of(CallId call) const;

  rsm::Monitor monitor_;
  PendingCalls pending_;
  std::size_t pending_units_ = 0;     // of the arguments of those
  std::map<Caller, CallId> awaited_;  // of those that are pending: whose response a core can receive
  Violations violations_;
};

}  // namespace race::services
