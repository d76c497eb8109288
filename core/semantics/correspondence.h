// Correspondence: which elements of an edited program are those of the program before (core/SEMANTICS.md section 9).
// Pure functions.
#pragma once

#include <vector>

#include "core/semantics/program.h"

namespace race::semantics {

/// For each element of the program after an edit, the same element of the program before; kNone if it is new.
struct Correspondence {
  Correspondence(const Program& before, const Program& after);
  /// Of a program that stays as it is, whatever ids are repeated in it.
  static Correspondence identity(const Program& program);

  PortId port(PortId p) const { return PortId{ports[index(p)]}; }

  std::vector<std::uint32_t> states, barriers, ports, actions, values;  // by number after the edit

 private:
  explicit Correspondence(const Program& after);
};

}  // namespace race::semantics
