// JournalSource: where the entries and checkpoints of a run are kept, for those who do the run again.
//
// Threads: one at a time.
#pragma once

#include <cstdint>
#include <vector>

#include "core/execution/journal.h"
#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::execution {

/// How many entries those ask for at once who read all.
inline constexpr std::uint64_t kEntriesAtOnce = 256;

class JournalSource {
 public:
  virtual ~JournalSource() = default;
  /// The entries of positions `from` to `to`, both from 1. Requires that they are there: 1 <= from <= to. Errors: its
  /// own (`corrupt`, `io`).
  virtual Expected<std::vector<JournalEntry>> entries(std::uint64_t from, std::uint64_t to) = 0;
  /// The last checkpoint whose position is at most `position` (schemas/checkpoint.json); unknown: there is none.
  virtual Expected<Value> checkpoint(std::uint64_t position) = 0;
};

/// Of a journal in memory, without checkpoints; a copy.
class MemoryJournal final : public JournalSource {
 public:
  explicit MemoryJournal(std::vector<JournalEntry> entries) : entries_(std::move(entries)) {}
  Expected<std::vector<JournalEntry>> entries(std::uint64_t from, std::uint64_t to) override {
    return std::vector(entries_.begin() + static_cast<std::ptrdiff_t>(from - 1),
                       entries_.begin() + static_cast<std::ptrdiff_t>(to));
  }
  Expected<Value> checkpoint(std::uint64_t) override { return Value::unknown(); }

 private:
  std::vector<JournalEntry> entries_;
};

}  // namespace race::execution
