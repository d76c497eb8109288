// One call of an operation by a person, as they say it and as they are answered; and those that wait for their
// responses.
//
// Threads: one at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/rsm/call_effect.h"
#include "core/value/expected.h"
#include "core/value/fields.h"
#include "core/value/value.h"
#include "server/threads/deadlines.h"
#include "services/host/delivery.h"

namespace race::server {

struct PersonCall {
  static constexpr std::size_t kMostUnits = 16U << 10U;  // of a response (Value::size_units)

  std::string service, operation;
  List args = {};
  Dict kwargs = {};
};

/// The fields `operation`, `args` and `kwargs` of a call of `service`; what does not fit is a violation.
PersonCall read_call(std::string service, Fields& fields);

/// What a service has answered: {"result"} or {"error"}, which is `too_large` of more than kMostUnits.
Dict response_json(const services::Delivery& delivery);
/// The same of a call that was not made.
Dict response_json(const Error& refused);

/// Calls of which nobody but the waiting one gets the response. What reads, what stops, and all else have places of
/// their own: none of the three keeps out the others.
class PersonCalls {
 public:
  enum class Place : std::uint8_t { reads, stops, others };
  static Place place_of(rsm::CallEffect effect);
  static constexpr std::size_t kMost = 16;          // of a place
  static constexpr std::size_t kMostOfAccount = 4;  // of these, so that one account does not keep out the others
  /// Gets the response, as response_json() has it, or why there is none in time. Under the host's lock: quick.
  using Respond = std::function<void(Expected<Dict> response)>;

  struct Waiting {
    Respond respond;
    Place place = Place::others;
    std::string account = {};     // whose share it has; empty: nobody's, where all calls are those of one person
    Deadlines::Id deadline = {};  // of the response
  };
  /// Whether one more of the account may wait at this place. Errors: `unavailable`: kMost do there; `too_large`:
  /// kMostOfAccount of it do.
  Expected<void> may_wait(Place place, std::string_view account) const;
  /// Waits from now on. Requires may_wait() and a number that none has.
  void add(std::uint64_t number, Waiting call) { calls_.emplace(number, std::move(call)); }
  /// Waits no more; nothing: it does not wait.
  std::optional<Waiting> take(std::uint64_t number);

 private:
  std::map<std::uint64_t, Waiting> calls_;  // by number
};

}  // namespace race::server
