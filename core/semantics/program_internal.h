// The two parts of Program::build.
#pragma once

#include <vector>

#include "core/semantics/program.h"

namespace race::semantics {

/// Numbers the elements of the model and connects them. Returns its states, by number.
std::vector<const rcm::State*> lay_out(Program& program, const rcm::NativeModel& model);

/// Compiles the code of these states. Requires that they are laid out.
std::vector<Error> compile_code(Program& program, const std::vector<const rcm::State*>& syntax);

}  // namespace race::semantics
