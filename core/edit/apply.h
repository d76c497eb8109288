// Applying edits to documents: as a whole or not at all. Pure functions.
#pragma once

#include "core/edit/operation.h"
#include "core/edit/tree.h"
#include "core/rcm/model.h"
#include "core/value/expected.h"

namespace race::edit {

/// Applies one operation and returns the one that takes it back. Errors: tree.h.
Expected<Operation> apply(Tree& tree, const Operation& operation);

/// Applies all operations in order and returns the edit that takes them back. If one is refused, the tree is as it was;
/// the path of the error is that of its field (`operations/2/after`). `too_large`: the text of the document could not
/// be read again.
Expected<Edit> apply(Tree& tree, const Edit& edit);

/// Applies operations that are known to fit, such as an inverse.
void apply_known(Tree& tree, const Edit& edit);

struct Applied {
  rcm::Document document;
  Edit inverse;
};
/// The same for a document, which must have ids (Tree::read).
Expected<Applied> apply(const rcm::Document& document, const Edit& edit);

}  // namespace race::edit
