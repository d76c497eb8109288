// Images for displays: checked data URLs, or files of one folder made into such.
#pragma once

#include <string>

#include "core/value/expected.h"

namespace race::display {

/// Characters of a data URL; its image has three quarters of that.
inline constexpr std::size_t kImageCharacters = 1'000'000;

/// The data URL of `image`: itself if it is one (base64 of PNG, JPEG, WebP, GIF or SVG), else that of the file of this
/// name in `folder` (no path, one of .png .jpg .jpeg .webp .gif .svg; read when called). Errors: `type` (no data URL of
/// an image, no name of one), `not_found`, `too_large`, `io`.
Expected<std::string> image_url(const std::string& image, const std::string& folder);

}  // namespace race::display
