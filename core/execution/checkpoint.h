// Checkpoint: a run between two macro steps as a JSON value (core/SEMANTICS.md section 10), from which it goes on as if
// it had never been written: same derivations, same calls, same numbers.
//
// Threads: a checkpoint is frozen: it may be read on any thread.
#pragma once

#include "core/execution/execution.h"
#include "core/execution/journal.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::execution {

/// schemas/checkpoint.json. Waiting inputs are part of it. Requires that no macro step is open.
Value checkpoint_json(const Execution& execution);

/// The execution that checkpoint_json was given, for the same header. `json` is a text as parse_json gives it with
/// kJournalLimits. Error, the first, at its place in the checkpoint (`run/states/Root/A/activations`): `version`; it is
/// not of this model or was changed: `type`, `missing`, `unknown_field`, `unknown_name`, `out_of_range`, `constant`,
/// `duplicate`, `conflict`. Nothing of it is used then.
Expected<Execution> read_checkpoint(const JournalHeader& header, const Value& json);

}  // namespace race::execution
