// Inputs of a run and entries of a journal: the run numbers events and operations by its program, a journal names them.
#pragma once

#include "core/execution/journal.h"
#include "core/semantics/run.h"

namespace race::execution {

/// The entry of an input that counts. Its data is frozen.
JournalEntry entry_of(const semantics::Run& run, semantics::Input& input);

/// The input of an event or response entry. Error `conflict`: the run does not take it (Run::counts), so the entry is
/// not of this run.
Expected<semantics::Input> input_of(const semantics::Run& run, const JournalEntry& entry);

}  // namespace race::execution
