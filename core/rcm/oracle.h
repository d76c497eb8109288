// Dynamic oracles (thesis 3.3.2, Figures 3.9 and 3.10): a composite that decides which of its children to enter,
// translated to basic RCM syntax: the Dispatcher state of the thesis.
#pragma once

#include <string_view>

#include "core/rcm/ids.h"
#include "core/rcm/model.h"

namespace race::rcm {

inline constexpr std::string_view kDispatcher = "Dispatcher";
inline constexpr std::string_view kLastActive = "last_active";

/// The dispatcher of a composite with an oracle: a port `to_C` for each child state C, and `otherwise` to the
/// composite's `first`, if it has one. Of an `external` oracle whose text is no call, it has no parameters and no
/// functions. Its elements have ids derived from the composite's.
State dispatcher(const State& composite, DerivedIds& ids);

/// Replaces the oracle of `composite` by its dispatcher and, for `history`, by the variable and actions that store the
/// last child. Requires an oracle without violations.
void translate_oracle(State& composite, DerivedIds& ids);

}  // namespace race::rcm
