// JPEG (ITU-T T.81), by libjpeg-turbo.
//
// Threads: any.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace race::server {

/// The bytes of a file; `colour`: red, green, blue of each pixel, by rows. Nothing: these are no such pixels, or the
/// library has no memory.
std::optional<std::string> jpeg(std::string_view colour, std::size_t width, std::size_t height);

}  // namespace race::server
