// The size of a document's text, which must be one that can be read again.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/edit/element.h"
#include "core/edit/tree.h"
#include "core/value/expected.h"

namespace race::edit {

/// At least as many bytes as the fields of an element take in the text of a document, wherever it stands.
std::size_t text_bound(const Content& content);

/// The same for an entry of the document.
std::size_t text_bound(std::string_view key, const Value& value);

/// Error `too_large` (`operations`) if the text of the document could not be read again. Writes the text only if the
/// bound of the tree does not say that it is short enough; then the bound is exact.
Expected<void> check_extent(Tree& tree);

}  // namespace race::edit
