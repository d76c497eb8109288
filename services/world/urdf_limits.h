// What a URDF text may be before the parser, which recurses as deep as the text does, sees it: it may come from another
// process. Pure function.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/value/expected.h"

namespace race::world {

inline constexpr std::size_t kUrdfDepth = 64;        // elements in each other
inline constexpr std::size_t kUrdfElements = 10000;  // comments count too
inline constexpr std::size_t kUrdfLinks = 1000;      // and as many joints
inline constexpr std::size_t kUrdfChain = 100;       // links from the root to the last one

/// XML as URDF files are: elements and comments after one declaration, no DOCTYPE, CDATA or instructions. Errors:
/// `too_deep`, `too_large`, `syntax` (also where parsers could disagree about what is an element).
Expected<void> check_urdf_text(std::string_view text);

}  // namespace race::world
