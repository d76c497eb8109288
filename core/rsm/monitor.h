// Monitor: checks a live service against its RSM (R18). The host reports what the service announces, in order; the
// monitor follows the transitions and returns violations. It never blocks, changes or answers anything. After a
// violation it continues from what was announced. Used by the service's host, on one thread.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/rsm/model.h"
#include "core/rsm/rules.h"
#include "core/value/value.h"

namespace race::rsm {

/// A violation: which rule (`Trans1`, `Trans2`, `Stutter`, `R7`, `R17`, `type`, `declared`, `respond`, `put`), why, and
/// in which call (0: none).
struct Violation {
  std::string rule, message;
  std::uint64_t call = 0;
  bool operator==(const Violation&) const = default;
};

class Monitor {
 public:
  using CallId = std::uint64_t;
  using Violations = std::vector<Violation>;

  /// A service in its initial state. Keeps a copy of the description. An interface has no transitions: only
  /// names, types and that each call is answered once are checked.
  explicit Monitor(Service service);

  /// A call was delivered to the service. Violations are the caller's: an undeclared operation, or arguments that are
  /// undeclared or of another type.
  Violations called(CallId call, std::string_view operation, const List& args, const Dict& kwargs);
  /// The service took transition `id`, on `call` or spontaneously (0), or spontaneously to answer `call`, one of
  /// several (R25).
  Violations transition(std::string_view id, CallId call);
  /// The call that the last transition() took the response from: it is open no longer (R17). 0: none.
  CallId superseded() const { return superseded_; }
  /// The service rejected a call (R7).
  Violations rejected(CallId call);
  Violations result(CallId call, const Value& value);
  /// An error response, a dict with at least `code`.
  Violations error(CallId call, const Value& value);
  Violations event(std::string_view name, const Value& data);
  /// The service has ended and a new one starts in its initial state; no call is open.
  void restarted();

  /// The current state as announced; empty for an interface.
  const std::string& current() const { return instance_.current; }
  /// Calls without a response, in order.
  std::vector<CallId> open_calls() const;

 private:
  /// A call without a response.
  struct OpenCall {
    std::string operation;
    enum class Progress { delivered, deferred, resolved } progress = Progress::delivered;
    std::optional<std::string> error_code;  // resolved by a transition with this `error`
  };

  using OpenCalls = std::map<CallId, OpenCall>;

  void follow(const Transition& t, CallId call);
  void check_source(const Transition& t, CallId call, Violations& out) const;
  void check_unannounced(Violations& out);
  /// The call has had its response.
  OpenCall close(OpenCalls::iterator call);
  /// Removes and returns the open call that a response is for; nothing if there is none.
  std::optional<OpenCall> answer(CallId call, Violations& out);
  const Operation* operation(std::string_view name) const;
  const Event* declared_event(std::string_view name) const;

  Service service_;
  Instance instance_;
  OpenCalls open_;
  std::string last_transition_;
  CallId superseded_ = 0;
  std::multiset<std::string, std::less<>> unannounced_;  // events of the last transition
};

}  // namespace race::rsm
