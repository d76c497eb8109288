// Whole files as texts.
#pragma once

#include <string>

#include "core/value/expected.h"

namespace race::server {

/// Error `io`, with the path: it cannot be read.
Expected<std::string> read_file(const std::string& path);

}  // namespace race::server
