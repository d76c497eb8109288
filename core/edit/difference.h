// The difference of two documents: the edit that makes the one of the other. Pure.
#pragma once

#include "core/edit/operation.h"
#include "core/edit/tree.h"
#include "core/value/expected.h"

namespace race::edit {

/// The edit after which `from` is `to`. Ids say what is the same: an element that stands elsewhere is moved, with all
/// that is in it, and of a list whose order has changed the fewest elements are moved; fields and entries are set one
/// by one. An element whose id now is of another kind (a parameter, once a port) is removed and inserted. Takes
/// O(n log n) of the elements.
///
/// Errors: `not_accepted`, no edit does this: another root, or a `layout`, `meta` or `notes` that is no object;
/// `too_large`, it would take more than kMaxOperations. apply() refuses the edit (`too_deep`) if on the way an element
/// stands deeper than a document can be written.
Expected<Edit> difference(const Tree& from, const Tree& to);

}  // namespace race::edit
