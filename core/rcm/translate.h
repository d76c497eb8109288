// Translation (core/SEMANTICS.md, section 6): a document with links, oracles and `after` becomes a native model, which
// is what executes. The document itself keeps its extended form for editing. Pure functions.
#pragma once

#include "core/rcm/model.h"
#include "core/value/expected.h"

namespace race::rcm {

/// The native model of `document`, with the origin of every node and port. The origin of a linking state and of the
/// ports that it names is itself; of what a link takes over, the element of the library; of what an oracle is
/// translated to, the composite. Returns the violations of a document that has some.
Checked<NativeModel> translate(const Document& document);

}  // namespace race::rcm
