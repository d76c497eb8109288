// The edit that makes a revision of the one before, where none was sent: so that it can be taken back as what was
// edited, also after a restart.
//
// Pure.
#pragma once

#include <optional>

#include "server/store/revision.h"
#include "server/store/revision_text.h"

namespace race::server {

/// The edit of the author of `next` that makes its text of that of `before`, as it is applied. Nothing: none does, such
/// as between other roots, or one of the texts cannot be edited.
std::optional<RevisionEdit> edit_between(const RevisionText& before, const RevisionText& next);

}  // namespace race::server
