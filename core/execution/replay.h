// Replay: recomputes what a run did from its journal. Derivations are never stored; this walks from the nearest
// checkpoint that it kept to the steps that were asked for.
//
// Threads: one at a time; shares nothing with the run itself but frozen values.
#pragma once

#include <atomic>
#include <map>
#include <memory>

#include "core/execution/execution.h"
#include "core/execution/journal_source.h"

namespace race::execution {

class Replay {
 public:
  static constexpr std::size_t kInterval = 256;    // macro steps between checkpoints, at least
  static constexpr std::size_t kCheckpoints = 64;  // kept at most

  /// Of the run of this header, whose journal is kept in `source`.
  Replay(JournalHeader header, std::shared_ptr<JournalSource> source, std::size_t interval = kInterval,
         std::size_t checkpoints = kCheckpoints)
      : header_(std::move(header)), source_(std::move(source)), interval_(interval), most_(checkpoints) {}

  // The journal may have grown since the last call; what was there is as it was. Somebody may set `stop`, which may be
  // null, when nobody waits any more: all end soon then, within a function or between micro steps. Errors of all: those
  // of the source; `conflict`: the journal is of another run; `unavailable`: it was stopped.

  /// Macro steps `from` to `to`, both counted from 1, as schemas/trace_step.json. Of macro step `last`
  /// only the first `micro` micro steps are shown, if it is not complete (`micro` >= 0). Requires 1 <= from <= to.
  Expected<List> steps(std::uint64_t from, std::uint64_t to, std::uint64_t last, int micro,
                       const std::atomic<bool>* stop = nullptr);

  /// The execution as it was before micro step `micro`, from 0, of macro step `step`, which has begun; as it was at the
  /// end of the macro step if it has fewer. Requires 1 <= step <= number of entries, micro >= 0.
  Expected<Execution> before(std::uint64_t step, int micro, const std::atomic<bool>* stop = nullptr);

  /// The execution after the first `position` macro steps (0: before the run began). No input waits. `stop` stops what
  /// it does next, too.
  Expected<Execution> after(std::uint64_t position, const std::atomic<bool>* stop = nullptr);

  /// `before`, an execution of this run, after one more macro step, of which there is the entry. As after().
  Expected<Execution> next(Execution before, const std::atomic<bool>* stop = nullptr);

 private:
  Expected<Execution> nearest(std::uint64_t position);
  void keep(const Execution& execution);

  JournalHeader header_;
  std::shared_ptr<JournalSource> source_;
  std::size_t interval_, most_;
  std::map<std::uint64_t, Execution> checkpoints_;  // by position
};

}  // namespace race::execution
