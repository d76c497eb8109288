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

#include "core/value/expected.h"
#include "core/value/fields.h"
#include "core/value/value.h"
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

/// Calls of which nobody but the waiting one gets the response.
class PersonCalls {
 public:
  static constexpr std::size_t kMost = 16;
  /// Gets the response, as response_json() has it. Under the host's lock: quick.
  using Respond = std::function<void(Dict response)>;

  /// Whether it waits now: not if kMost others do.
  bool add(std::uint64_t number, Respond respond);
  /// Waits no more; nothing: it does not wait.
  std::optional<Respond> take(std::uint64_t number);

 private:
  std::map<std::uint64_t, Respond> calls_;  // by number
};

}  // namespace race::server
