// Derivation documents on stdout, for the commands derive and replay.
#pragma once

#include "core/value/value.h"

namespace race::server {

/// Prints `document` as JSON, or as a transcript (core/semantics/derivation_text.h). Returns kExitFindings if the run
/// faulted, else kExitOk.
int print_derivations(const Value& document, bool as_text);

}  // namespace race::server
