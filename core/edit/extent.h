// The size of a document's text.
#pragma once

#include "core/edit/tree.h"
#include "core/value/expected.h"

namespace race::edit {

/// Error `too_large` (`operations`) if the text of the document could not be read again. Writes the text only if it is
/// not surely short enough.
Expected<void> check_extent(const Tree& tree);

}  // namespace race::edit
