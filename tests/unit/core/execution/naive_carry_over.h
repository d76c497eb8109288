// What core/SEMANTICS.md section 9 says of a carried run, computed again from its text: checkpoints and native models
// as JSON, by ids and names alone. For models whose elements all have ids. Slow and plain, to compare with Run::edited.
#pragma once

#include <set>
#include <string>

#include "core/value/value.h"

namespace race::execution {

/// A run between two macro steps, its model, and the model that it is edited to.
struct Carrying {
  const Value& checkpoint;      // of Run::checkpoint_json()
  const Value &before, &after;  // the roots of the native models
};

/// The paths of the outermost active nodes that the edited model does not have.
std::set<std::string> lost_paths(const Carrying& run);

/// "Root/A.p" of the new parameters of active states whose value the text says without evaluating an expression that
/// is more than `par.x`, `var.x` or `res.x`: those that do not resolve. Requires no lost paths.
std::set<std::string> unresolved_parameters(const Carrying& run);

/// Where `carried`, the checkpoint at the beginning of the edit's macro step, is not what the text says; empty if it
/// is. What depends on code that would have to be evaluated or compiled to be known is checked as far as it is known.
std::string carry_over_difference(const Carrying& run, const Value& carried);

}  // namespace race::execution
