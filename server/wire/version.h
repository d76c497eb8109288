// The version of the program and its interface. It is set once, in the CMakeLists.txt of the project.
#pragma once

#include <string_view>

namespace race::server {

/// "0.1.0"
std::string_view version();
/// What the program was built with: "GNU 12.2.0, Release".
std::string_view compiler();

}  // namespace race::server
