// Monitor: holds a live service against its RSM (R18). It is told what the service announces, in order, follows it and
// says what does not fit; it never blocks, changes or answers anything. After a violation it goes on from what was
// announced. Lives where the service's host lives, on one thread.
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

/// What does not fit: by which rule (`Trans1`, `Trans2`, `Stutter`, `R7`, `R17`, `type`, `declared`, `respond`, `put`),
/// why, and in which call (0: none).
struct Violation {
  std::string rule, message;
  std::uint64_t call = 0;
  bool operator==(const Violation&) const = default;
};

class Monitor {
 public:
  using CallId = std::uint64_t;
  using Violations = std::vector<Violation>;

  /// A service in its initial state. Keeps a copy of the description. A mere interface has no transitions: of it,
  /// names, types and that each call is answered once are held.
  explicit Monitor(Service service);

  /// A call was handed to the service. Violations are the caller's: an undeclared operation, arguments that it does not
  /// have or that are not of their type.
  Violations called(CallId call, std::string_view operation, const List& args, const Dict& kwargs);
  /// The service took transition `id`, on `call` or spontaneously (0).
  Violations transition(std::string_view id, CallId call);
  /// The service rejected a call (R7).
  Violations rejected(CallId call);
  Violations result(CallId call, const Value& value);
  /// An error response, a dict with at least `code`.
  Violations error(CallId call, const Value& value);
  Violations event(std::string_view name, const Value& data);
  /// The service is gone; a new one starts in its initial state, and no call is open.
  void restarted();

  /// The current state as announced; empty for a mere interface.
  const std::string& current() const { return instance_.current; }
  /// Calls without a response, in order.
  std::vector<CallId> open_calls() const;

 private:
  /// A call without a response, and how far it is.
  struct Open {
    std::string operation;
    enum class Stage { handed, deferred, resolved } stage = Stage::handed;
    std::optional<std::string> error_code;  // resolved by a transition with this `error`
  };

  void follow(const Transition& t, CallId call);
  void check_source(const Transition& t, CallId call, Violations& out) const;
  void check_unannounced(Violations& out);
  /// The call that a response is for, removed; nothing if there is none, or it has no response yet.
  std::optional<Open> answer(CallId call, Violations& out);
  const Operation* operation(std::string_view name) const;
  const Event* declared_event(std::string_view name) const;

  Service service_;
  Instance instance_;
  std::map<CallId, Open> open_;
  std::string last_transition_;
  std::multiset<std::string, std::less<>> owed_;  // events of the last transition that were not announced yet
};

}  // namespace race::rsm
