// Whole files as texts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/value/expected.h"

namespace race::server {

/// The largest file that the server reads as a whole [bytes].
inline constexpr std::size_t kMaxFile = std::size_t{64} << 20U;

/// The rest of what is open as `descriptor`, of any kind. Errors, with an empty path: `io`, `too_large`: it has more
/// than `most` bytes; no more than that and a block is read then.
Expected<std::string> read_open_file(int descriptor, std::size_t most);

/// Errors, with the path: `io`: it is no file (a folder, a pipe), or cannot be read; `too_large`.
Expected<std::string> read_file(const std::string& path, std::size_t most = kMaxFile);

/// Whether there is this file. Error `io`, with the path: that cannot be found out, or it is no file (a folder, a
/// pipe).
Expected<bool> file_exists(const std::string& path);

/// Makes `text` the content of the file, whole or not at all: writes a file beside it, with its permissions, and
/// renames that. Of a symbolic link, the file that it leads to. Requires that the file exists. Error `io`, with the
/// path: it cannot be written and is as it was.
Expected<void> replace_file(const std::string& path, std::string_view text);

/// Of a file for the user of the server alone.
inline constexpr unsigned kOwnerAlone = 0600;

/// The same of a file that may not be there yet; it has these permissions. Not through symbolic links.
Expected<void> write_file(const std::string& path, std::string_view text, unsigned permissions);

}  // namespace race::server
