// The size of a document's native model, computed without building it: links to links multiply.
#pragma once

#include <cstddef>

#include "core/rcm/library.h"
#include "core/rcm/model.h"

namespace race::rcm {

struct Extent {
  // Counting of states and bytes stops soon after their limits (constraints.h).
  std::size_t states = 0;  // states and barriers
  std::size_t bytes = 0;   // of names and code; an element without text counts a few
  std::size_t depth = 0;   // levels of states, each link counted as a level
};

/// The larger extent of the root and of each state of the library. Requires that every link leads to a state
/// and that there are no cycles.
Extent extent_of(const Document& document, const Library& library);

}  // namespace race::rcm
