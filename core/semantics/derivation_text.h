// The derivation document of core/SEMANTICS.md section 7 as a text for people: indented, one node of a tree a line.
// Changes of it are read as a line diff.
#pragma once

#include <string>

#include "core/value/value.h"

namespace race::semantics {

/// The transcript of a derivation document, such as derive_texts() gives. For each step its trees, its calls, the
/// active states, and the values that changed since the step before; at the end the status:
///
///     step 1
///       micro 1
///         Micro 3.31 at Root (R13)
///           Cond 4.12 at Root, port done = true requires timer.wait.result
///       call timer.wait(0.5)
///       active Root
///       set Root par.seconds = 0.5
///     ended: done
///
/// A field that is missing is left out. Names that are no identifiers, values and messages are written as JSON, so that
/// none of them breaks a line.
std::string derivation_text(const Value& document);

}  // namespace race::semantics
