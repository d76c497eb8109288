// Static analysis of conditions, for speed alone: the results of evaluation are the same without it.
#pragma once

#include "core/language/compile/program.h"

namespace race::language {

/// The comparison that `condition` is as a whole, if it is one of a datum, or of a field of it, with a number.
Comparison comparison_of(const Program& condition);

/// Whether `condition`, without an occurrence of an event, is never true and never a fault.
bool needs_occurrence(const Program& condition, const ServiceTable& services);

}  // namespace race::language
