// The model that a run executes, which edits replace (core/SEMANTICS.md section 9).
#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/execution/journal.h"
#include "core/rsm/model.h"
#include "core/value/expected.h"

namespace race::execution {

/// Of a run that has not been edited: what its header has.
struct ExecutedModel {
  Value native = Value::unknown();                    // schemas/native.json, frozen; unknown: entries cannot edit it
  std::shared_ptr<const semantics::Program> program;  // shared by the run and its replays
  std::int64_t revision = 0;                          // of the document, if an edit has said so; else 0
};

using Interfaces = std::map<std::string, rsm::Service>;

/// The names and flags of services that the program was compiled with, as `services` of schemas/journal.json.
Dict interfaces_json(const semantics::Program& program);

/// Reads what interfaces_json wrote: names, `safe` and `sampled`. Adds violations to `errors`, at `PATH/KEY/...`.
Interfaces read_interfaces(const Dict& json, const std::string& path, std::vector<Error>& errors);

/// A native model (schemas/native.json), compiled. Errors: those of rcm::read_native at `path`, of the program at
/// `PATH/document/...`.
Checked<ExecutedModel> build_model(Value native, const Interfaces& services, const std::string& path);

/// The entry that makes of `before` the model `native`, compiled with `services`; what `before` was compiled with
/// besides these stays. Errors: those of edit::Tree::read (an element has no id) and edit::difference (`not_accepted`:
/// another root; `too_large`: more operations than an edit may have).
Expected<EditEntry> edit_between(const ExecutedModel& before, const Value& native, const Interfaces& services);

/// The model after the entry, whose text may be what that of a journal may be (`too_deep`, `too_large`). Errors: those
/// of edit::apply, at `operations/N/...`; of the document, the interfaces and the program that come of it, at
/// `native/...` and `services/...`.
Checked<ExecutedModel> edited(const ExecutedModel& before, const EditEntry& entry);

}  // namespace race::execution
