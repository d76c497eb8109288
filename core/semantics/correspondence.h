// Correspondence: which elements of an edited program are those of the program before (core/SEMANTICS.md section 9).
// Pure functions.
#pragma once

#include <vector>

#include "core/semantics/program.h"

namespace race::semantics {

/// For each element of the program after an edit, the same element of the program before; kNone if it is new.
struct Correspondence {
  Correspondence(const Program& before, const Program& after);

  StateId state(StateId s) const { return StateId{states[index(s)]}; }
  PortId port(PortId p) const { return PortId{ports[index(p)]}; }

  std::vector<std::uint32_t> states, barriers, ports, actions, values;  // by number after the edit
};

}  // namespace race::semantics
