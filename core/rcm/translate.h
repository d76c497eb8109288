// Translation (core/SEMANTICS.md, section 6): a document with links and oracles becomes a native model, which is what
// executes. The document itself keeps its extended form for editing. Pure functions.
#pragma once

#include "core/rcm/model.h"
#include "core/value/expected.h"

namespace race::rcm {

/// The native model of `document`, with the origin of every node and port: of a linking state and the ports that it
/// names, itself; of what a link takes over, the place in the library; of what an oracle makes, the composite. A
/// document with violations does not translate: they are what is returned.
Checked<NativeModel> translate(const Document& document);

}  // namespace race::rcm
