// JournalWalk: does the macro steps of a run again, one after the other, from where an execution stands.
//
// Threads: one at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/execution/execution.h"
#include "core/execution/journal_source.h"

namespace race::execution {

class JournalWalk {
 public:
  /// From `execution`, which no input waits for, to macro step `last` of its journal.
  JournalWalk(Execution execution, std::shared_ptr<JournalSource> source, std::uint64_t last)
      : execution_(std::move(execution)), source_(std::move(source)), last_(last) {}
  /// From the beginning. Errors: those of Execution::create.
  static Expected<JournalWalk> create(const JournalHeader& header, std::shared_ptr<JournalSource> source,
                                      std::uint64_t last);

  const Execution& execution() const { return execution_; }
  bool at_end() const { return execution_.run().position() >= last_; }
  /// The next macro step, whole; valid until the one after it. Requires that it is not at the end. Errors: those of the
  /// source; `conflict` at `entries/N`, from 0: the run does not take it.
  Expected<const Progress*> next(Recording recording);

 private:
  Execution execution_;
  std::shared_ptr<JournalSource> source_;
  std::uint64_t last_;
  std::vector<JournalEntry> block_;  // entries that were read
  std::uint64_t first_ = 0;          // position of the first of them
};

}  // namespace race::execution
