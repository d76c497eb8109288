// Replay: recomputes the derivations of a run from its journal. Derivations are never stored; this walks from the
// nearest checkpoint that it kept to the steps that were asked for.
//
// Threads: one at a time; shares nothing with the run itself but frozen values.
#pragma once

#include <map>

#include "server/execution/journal.h"

namespace race::server {

class Replay {
 public:
  explicit Replay(JournalHeader header);

  /// Macro steps `from` to `to` of `journal`, both counted from 1, as schemas/trace_step.json. Of the last entry only
  /// the first `micro` micro steps are shown if it is not complete (`micro` >= 0). Requires 1 <= from <= to <= number
  /// of entries; the journal is longer than or equal to that of the call before.
  List steps(const std::vector<JournalEntry>& journal, std::size_t from, std::size_t to, int micro);

  /// schemas/why.json as things were before micro step `micro`, from 0, of macro step `step`; as they were at the end
  /// of the macro step if it has fewer. Requires 1 <= step <= number of entries, micro >= 0, and of `journal` the same
  /// as `steps`.
  Value why(const std::vector<JournalEntry>& journal, std::size_t step, int micro, semantics::PortId port);

 private:
  semantics::Run& at(const std::vector<JournalEntry>& journal, std::size_t position);

  static constexpr std::size_t kInterval = 256;    // macro steps between checkpoints, at least
  static constexpr std::size_t kCheckpoints = 64;  // kept at most

  JournalHeader header_;
  std::size_t interval_ = kInterval;
  std::map<std::size_t, semantics::Run> checkpoints_;  // by position
  std::optional<semantics::Run> run_;
};

/// A macro step that was done with `recorder`, as schemas/trace_step.json.
Value trace_step(const semantics::Run& run, const semantics::Derivation& derivation, Value input, std::size_t step,
                 const std::vector<semantics::OutgoingCall>& calls);
/// schemas/call.json
Value call_json(const semantics::OutgoingCall& call);

}  // namespace race::server
