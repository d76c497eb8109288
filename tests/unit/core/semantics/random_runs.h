// What tests with random runs share: how they are set, and when two runs of a model are in the same state.
#pragma once

#include <cstdint>
#include <cstdlib>

#include "core/semantics/context.h"

namespace race::semantics {

/// A number from the environment, such as RACE_SEED.
inline std::uint64_t setting(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Δ and Σ, with the stamps that decide what runs again.
inline bool same(const RunState& a, const RunState& b) {
  return a.values == b.values && a.flags == b.flags && a.arrived == b.arrived && a.call_count == b.call_count &&
         a.calls == b.calls && a.tick == b.tick && a.executed == b.executed && a.served == b.served &&
         a.triggered == b.triggered && a.event_data == b.event_data && a.services_called == b.services_called;
}

}  // namespace race::semantics
