// Whole files as texts.
#pragma once

#include <string>
#include <string_view>

#include "core/value/expected.h"

namespace race::server {

/// Error `io`, with the path: it cannot be read.
Expected<std::string> read_file(const std::string& path);

/// Makes `text` the content of the file, whole or not at all: writes a file beside it, with its permissions, and
/// renames that. Of a symbolic link, the file that it leads to. Requires that the file exists. Error `io`, with the
/// path: it cannot be written and is as it was.
Expected<void> replace_file(const std::string& path, std::string_view text);

}  // namespace race::server
