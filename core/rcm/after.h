// Time-outs of ports (`after`), translated to basic RCM syntax: a child state that calls the timer when its parent is
// activated. In the manner of the extensions of thesis 3.3; core/SEMANTICS.md, section 6.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/rcm/ids.h"
#include "core/rcm/model.h"

namespace race::rcm {

inline constexpr std::string_view kAfterBarrier = "After";
inline constexpr std::string_view kDue = "due";
inline constexpr std::string_view kTimer = "timer";  // key of the service that is called

/// The name of the state that waits for the port: `After_p`.
std::string after_name(std::string_view port);

/// The state that waits for a port with `after`: its parameter `seconds` [s], its port `due`. Its elements have ids
/// derived from the port's.
State after_state(const Port& port, DerivedIds& ids);

/// Whether the states that wait need a barrier: the state has a `first` already, or they are several.
bool has_after_barrier(const State& state);

/// Replaces the `after` of the ports of `state` by the states that wait. Requires a state without violations, whose
/// oracle has been translated.
void translate_after(State& state, DerivedIds& ids);

}  // namespace race::rcm
