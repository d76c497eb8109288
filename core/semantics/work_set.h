// The work set of a run: the states that have to be visited in a micro step. A change in Δ or Σ marks the states whose
// conditions and actions read what has changed as dirty; RunState::work_set holds them in tree order.
#pragma once

#include "core/semantics/context.h"

namespace race::semantics {

/// The conditions and actions of `s` are evaluated again: in this micro step if `s` comes later in tree order, else in
/// the next.
inline void mark_dirty(RunState& run, StateId s) {
  run.live[index(s)].dirty = true;
  run.work_set.add(s);
}

/// The same in the next macro step, when `executed` and `triggered` are empty.
inline void recheck_in_next_macro_step(RunState& run, StateId s) {
  if (run.live[index(s)].recheck) return;
  run.live[index(s)].recheck = true;
  run.recheck.push_back(s);
}

/// Marks every active state whose conditions or actions read the event, or a response of the operation.
void mark_event_readers(RunState& run, const Program& program, EventId event);
void mark_response_readers(RunState& run, const Program& program, OperationId operation);

}  // namespace race::semantics
