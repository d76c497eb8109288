// The number of a stored run, as commands read it.
#pragma once

#include <string>

#include "server/store/runs.h"

namespace race::server {

/// Error `type`, at `path`: the text is no number of a run.
Expected<RunId> read_run_number(const std::string& text, const std::string& path);

}  // namespace race::server
