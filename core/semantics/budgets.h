// What bounds a run (header of the journal, core/SEMANTICS.md section 10). Each bound is a function of the run, so a
// replay meets it where the run did.
#pragma once

#include <cstdint>

#include "core/language/evaluate/interpreter.h"

namespace race::semantics {

struct Budgets {
  language::Interpreter::Limits evaluation;
  std::uint32_t micro_steps = 10'000;  // of one macro step; one more is a divergence
  // Of one macro step:
  std::uint64_t work = 10'000'000;         // units of work of its functions and parameters
  std::uint64_t calls = 5'000;             // of its functions
  std::uint64_t output_units = 1'000'000;  // of what its functions send and print
  std::uint64_t data_units = 4'000'000;    // of the values in Δ
  /// The header of the journal has none of the last four: an earlier version wrote it.
  bool is_earlier = false;
};

/// What the functions and parameters of a macro step have used of its budgets.
struct MacroStepUse {
  std::uint64_t work = 0, calls = 0, output_units = 0;
};

}  // namespace race::semantics
