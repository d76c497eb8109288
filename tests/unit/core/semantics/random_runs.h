// What tests with random runs share: when two runs of a model are in the same state.
#pragma once

#include "core/semantics/context.h"
#include "tests/unit/setting.h"

namespace race::semantics {

/// Δ and Σ, with the stamps that decide what runs again.
inline bool same(const RunState& a, const RunState& b) {
  return a.values == b.values && a.flags == b.flags && a.arrived == b.arrived && a.call_count == b.call_count &&
         a.calls == b.calls && a.tick == b.tick && a.executed == b.executed && a.served == b.served &&
         a.triggered == b.triggered && a.event_data == b.event_data && a.services_called == b.services_called;
}

}  // namespace race::semantics
