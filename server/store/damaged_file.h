// What is done with a damaged file that another one replaces: it is kept under another name.
//
// Threads: any.
#pragma once

#include <filesystem>
#include <string>

#include "core/value/expected.h"

namespace race::server {

/// Renames the SQLite file at `path` to `path`.damaged-`time`, and its log likewise, if it is `corrupt`. A file that is
/// sound or not there stays. Requires that nobody has it open. Errors: `storage`, `io`: whether it is damaged cannot be
/// told, or it cannot be renamed.
Expected<void> set_aside_if_damaged(const std::filesystem::path& path, const std::string& time);

}  // namespace race::server
