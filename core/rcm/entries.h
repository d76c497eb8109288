// Entries: what is written of `meta` and `layout`, the parts of a document that hold whatever an editor puts there, and
// many people at once. Their keys are put in order, and what has no entries is left out, so that setting an entry and
// taking it back restores the text. Pure functions.
#pragma once

#include "core/rcm/model.h"

namespace race::rcm {

/// An object with its entries in order of their keys (byte by byte); null if it has none. Anything else as it is.
Value ordered_entries(const Value& entries);

/// The same of the `meta` of a document, whose `notes` are entries, too.
Value ordered_document_meta(const Value& meta);

/// The `meta` of an element as JSON: its id, then the other entries in order; null if it says nothing.
Value meta_json(const Meta& meta);

}  // namespace race::rcm
