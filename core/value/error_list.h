// Lists of errors are bounded, as an input may have as many errors as it has bytes: the first kMaxErrors are listed.
// Who checks an input looks for one more, which says that there are more, and for none after it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/value/expected.h"

namespace race {

inline constexpr std::size_t kMaxErrors = 200;
/// A longer path or message of an error is cut there, at a character: an input chooses how long its names are.
inline constexpr std::size_t kMaxErrorBytes = 4096;

inline bool is_full(const std::vector<Error>& errors) { return errors.size() > kMaxErrors; }

/// Appends `error`, its texts cut, unless `errors` is full.
void add_error(std::vector<Error>& errors, Error error);

}  // namespace race
