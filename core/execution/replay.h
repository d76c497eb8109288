// Replay: recomputes what a run did from its journal. Derivations are never stored; this walks from the nearest
// checkpoint that it kept to the steps that were asked for.
//
// Threads: one at a time; shares nothing with the run itself but frozen values.
#pragma once

#include <map>

#include "core/execution/execution.h"

namespace race::execution {

class Replay {
 public:
  static constexpr std::size_t kInterval = 256;    // macro steps between checkpoints, at least
  static constexpr std::size_t kCheckpoints = 64;  // kept at most

  explicit Replay(JournalHeader header, std::size_t interval = kInterval, std::size_t checkpoints = kCheckpoints)
      : header_(std::move(header)), interval_(interval), most_(checkpoints) {}

  // `entries`: those of the journal; they begin with those of the calls before. Error of all `conflict`: the journal is
  // of another run.

  /// Macro steps `from` to `to`, both counted from 1, as schemas/trace_step.json. Of the last entry only the first
  /// `micro` micro steps are shown if it is not complete (`micro` >= 0). Requires 1 <= from <= to <= number of entries.
  Expected<List> steps(const std::vector<JournalEntry>& entries, std::size_t from, std::size_t to, int micro);

  /// The execution as it was before micro step `micro`, from 0, of macro step `step`, which has begun; as it was at the
  /// end of the macro step if it has fewer. Requires 1 <= step <= number of entries, micro >= 0.
  Expected<Execution> before(const std::vector<JournalEntry>& entries, std::size_t step, int micro);

 private:
  Expected<Execution> after(const std::vector<JournalEntry>& entries, std::size_t position);
  void keep(const Execution& execution);

  JournalHeader header_;
  std::size_t interval_, most_;
  std::map<std::size_t, Execution> checkpoints_;  // by position
};

/// The derivation document of a journal (core/SEMANTICS.md section 7), a step for each entry; after an abort (section
/// 10), which has no micro steps, its status is `aborted`. Error `conflict`, at the
/// entry: the run does not take it.
Expected<Value> derive_journal(const Journal& journal);

}  // namespace race::execution
