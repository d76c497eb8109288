// The files of the browser pages: everything below one folder, read when it is asked for.
#pragma once

#include <optional>
#include <string>

#include "server/http/message.h"

namespace race::server {

/// The file of `path` below `folder`; "/" and folders are their index.html. Nothing: no such file, one outside of the
/// folder, or no folder (empty). Files whose names carry a hash (below /assets/) may be kept for ever.
std::optional<Reply> static_file(const std::string& folder, const std::string& path);

}  // namespace race::server
