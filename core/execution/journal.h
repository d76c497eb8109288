// Journal: what a run is a function of (core/SEMANTICS.md section 10): a header, and its inputs in order of delivery,
// each one macro step. Entries name services, events and operations; no number in them depends on the program.
//
// Threads: the values in a journal are frozen: copies may be read on any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/edit/operation.h"
#include "core/rcm/constraints.h"
#include "core/semantics/force.h"
#include "core/semantics/run.h"
#include "core/value/expected.h"
#include "core/value/json.h"
#include "core/value/value.h"

namespace race::execution {

/// The version of core/SEMANTICS.md by which a journal is replayed. It changes when a run of an old journal would.
inline constexpr std::string_view kSemanticsVersion = "1";

/// What the text of a journal may be. A native model has its links expanded, so it is larger and deeper than a
/// document: each level of states is two levels of JSON.
inline constexpr JsonLimits kJournalLimits{
    .depth = 2 * rcm::kMaxDepth + 2 * JsonLimits{}.depth, .bytes = 2 * rcm::kMaxBytes, .keep_out_of_range = true};

/// The root is activated.
struct StartEntry {
  bool operator==(const StartEntry&) const = default;
};
/// An event occurs.
struct EventEntry {
  std::string service, event;
  Value data;
  bool operator==(const EventEntry&) const = default;
};
/// Call number `call`, from 1, is answered, rejected or lost.
struct ResponseEntry {
  std::uint64_t call = 0;
  std::string service, operation;
  bool is_error = false;
  Value data;
  bool operator==(const ResponseEntry&) const = default;
};
/// The model is edited (core/SEMANTICS.md section 9); executed_model.h makes and applies entries.
struct EditEntry {
  edit::Edit edit;            // of the native model before it
  Dict origin;                // what changes in the native model's `origin`; null: no longer there
  Dict services;              // interfaces that are new, or others than before, as the header has them
  std::int64_t revision = 0;  // of the document that it leads to; 0: not known
  bool operator==(const EditEntry&) const = default;
};
/// Somebody sets a value, or takes a port.
struct ForceEntry {
  semantics::Force force;
  bool operator==(const ForceEntry&) const = default;
};
/// The run is ended from outside.
struct AbortEntry {
  bool operator==(const AbortEntry&) const = default;
};
/// One macro step each.
using JournalEntry = std::variant<StartEntry, EventEntry, ResponseEntry, EditEntry, ForceEntry, AbortEntry>;

struct JournalHeader {
  Value native;                                       // schemas/native.json; frozen
  std::shared_ptr<const semantics::Program> program;  // shared by the run and its replays
  Dict arguments;                                     // frozen
  semantics::Budgets budgets;
};

struct Journal {
  JournalHeader header;
  std::vector<JournalEntry> entries;  // entry i is macro step i + 1
};

/// schemas/input.json
Value input_json(const JournalEntry& entry);

/// The `header` of schemas/journal.json.
Value header_json(const JournalHeader& header);

/// schemas/journal.json
Value journal_json(const Journal& journal);

/// Reads what header_json wrote, as read_journal does.
Checked<JournalHeader> read_header(const Value& json);

/// Reads what input_json wrote: the entry after `before`, null for the first one. Errors: those of one entry of
/// read_journal, but for names: what the model of that time does not have, its run does not take.
Checked<JournalEntry> read_input(const Value& json, const JournalEntry* before);

/// Reads what journal_json wrote; the program is built anew, from the native model and the interfaces of the services.
/// `json` is a text as parse_json gives it with kJournalLimits. A journal is refused as a whole. All errors of the
/// header are listed, of the entries those of the first wrong one, at paths such as `entries/3/input/kind`. Codes:
/// those of Fields, rcm::read_native (at `header/native`) and semantics::check_arguments (at `header/arguments`);
/// `version` of the semantics; `type` of the first entry, which is the start or an abort, and of one after these;
/// `unknown_name` of what the program has no input for, before the first edit; `out_of_range` of positions, numbers of
/// calls and budgets; `too_deep` of data; those of edit::read_edit. Whether a response answers a call that counts, and
/// whether an edit fits, is known only when the run has come there.
Checked<Journal> read_journal(const Value& json);

/// script.json: with the native model, `race derive` gives this run's derivations. It is closed and its services are
/// mere interfaces: every answer stands in the script.
Value script_json(const Journal& journal);

}  // namespace race::execution
