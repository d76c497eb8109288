// What the form of a condition tells before it is evaluated. All of it is for speed alone: evaluating says the same.
#pragma once

#include <optional>

#include "core/language/program_internal.h"

namespace race::language {

/// The comparison that `condition` is as a whole, if it is one of a datum, or of a field of it, with a number.
Comparison comparison_of(const Program& condition);

/// OPTIMIZATION: the truth of a Comparison. Nothing where evaluating would meet anything but numbers.
/// Requires that nobody traces and that the budget allows Comparison::kUnits.
std::optional<Truth> decide(const Program& condition, const Environment& environment);

/// Whether `condition`, without an occurrence of an event, is never true and never a fault.
bool needs_occurrence(const Program& condition, const ServiceTable& services);

}  // namespace race::language
