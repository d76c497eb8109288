// Whether the joints of a URDF text make trees. urdfdom takes other ones, too, and never gives back the memory of links
// that are their own ancestors: each text with a loop, which may come from another process, would cost some. Pure
// function.
#pragma once

#include <string>

#include "core/value/expected.h"

namespace race::world {

/// `text` as check_urdf_text() takes it; what is no URDF otherwise passes. Errors: `duplicate`, two joints lead to one
/// link; `conflict`, a link is its own ancestor.
Expected<void> check_urdf_tree(const std::string& text);

}  // namespace race::world
