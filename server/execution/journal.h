// Journal: what a run is a function of (core/SEMANTICS.md section 10): a header, and its inputs in order of delivery,
// each one macro step. Kept in memory. Values in it are frozen: a copy may be read on another thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/semantics/run.h"
#include "core/value/value.h"

namespace race::server {

struct JournalHeader {
  Value native;                                       // schemas/native.json; frozen
  std::shared_ptr<const semantics::Program> program;  // shared by the run and its replays
  Dict arguments;                                     // frozen
  semantics::Budgets budgets;
};

struct JournalEntry {
  enum class Kind : std::uint8_t { start, input, abort } kind = Kind::start;
  semantics::Input input;  // of `input`
};

struct Journal {
  JournalHeader header;
  std::vector<JournalEntry> entries;  // entry i is macro step i + 1
};

/// schemas/input.json
Value input_json(const semantics::Program& program, const JournalEntry& entry);
/// schemas/journal.json
Value journal_json(const Journal& journal);
/// script.json: with the native model, `race derive` gives this run's derivations. It is closed and its services are
/// mere interfaces: every answer stands in the script.
Value script_json(const Journal& journal);

}  // namespace race::server
