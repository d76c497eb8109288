// The variables that code of a state names: var.x may be used undeclared (core/SEMANTICS.md, section 1).
#pragma once

#include <string>
#include <vector>

#include "core/rcm/model.h"

namespace race::rcm {

/// x for each var.x in the code of the state and in the expressions of its children's parameters, in this order; of
/// texts that cannot be parsed, none.
std::vector<std::string> used_variables(const State& state);

}  // namespace race::rcm
