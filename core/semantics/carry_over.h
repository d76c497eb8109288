// Carrying a run over to an edited program (core/SEMANTICS.md section 9): what stays of Δ and Σ, and what holds the
// edit up. Pure functions.
#pragma once

#include <string>
#include <vector>

#include "core/semantics/context.h"
#include "core/semantics/correspondence.h"

namespace race::semantics {

/// Why an edit waits: something of the run that the edited model has no place for.
struct Obstacle {
  enum class Kind : std::uint8_t {
    active,      // a node is active that the edited model does not have in this place
    unresolved,  // a parameter of an active state would have no value
  } kind = Kind::active;
  std::string path, id;  // the node, in the model before the edit; of `unresolved`: the state, in the one after it
  std::string parameter = {};  // of `unresolved`
  bool operator==(const Obstacle&) const = default;
};

/// The outermost active nodes of `run` that the edited program does not have: states in tree order, then barriers.
std::vector<Obstacle> lost_nodes(const Program& before, const RunState& run, const Correspondence& same);

/// Δ and Σ of `run` as far as `after` has a place for them, at the beginning of the macro step that delivers the edit:
/// no occurrence, `executed` and `triggered` empty. Parameters of active states that are new have no value yet, and
/// lists and counts are those of a new run. Requires that there are no lost nodes.
RunState carried_state(const Program& before, const RunState& run, const Program& after, const Correspondence& same);

/// activated(b) ∩ in'(b) can be all of in'(b): then b becomes active. Requires arrivals that are carried over.
void open_complete_barriers(const Program& program, RunState& run);

}  // namespace race::semantics
