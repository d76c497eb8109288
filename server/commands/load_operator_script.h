// The operator script that an option names, for `race run` and `race serve`.
#pragma once

#include <string>

#include "server/cell/operator_script.h"
#include "server/commands/file_errors.h"

namespace race::server {

/// Reads the script of a file, or of the standard input (input.h).
tl::expected<OperatorScript, FileErrors> load_operator_script(const std::string& file);

}  // namespace race::server
