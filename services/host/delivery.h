// Delivery: what a service says to cores: an event to all of them, a response to the caller alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

#include "services/host/call_ledger.h"

namespace race::services {

struct Delivery {
  enum class Kind { event, response } kind = Kind::event;
  Time time = 0;
  std::size_t service = 0;     // number of the service in order of declaration
  std::uint64_t sequence = 0;  // counts deliveries of the host
  std::string key, name;       // of the service; of the event or the operation
  Value data;                  // frozen
  bool is_error = false;       // of a response
  Caller caller;               // of a response
  std::size_t units = 0;       // of `data` (Value::size_units): counted once, for all cores
};

/// The order in which deliveries reach cores: (time, service, sequence).
inline bool before(const Delivery& a, const Delivery& b) {
  return std::tie(a.time, a.service, a.sequence) < std::tie(b.time, b.service, b.sequence);
}

}  // namespace race::services
