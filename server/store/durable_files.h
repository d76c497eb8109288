// What a loss of power leaves of files that are no databases.
//
// Threads: any.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/value/expected.h"

namespace race::server {

/// A new file, on the disk when it returns; its name is when its folder is synchronised. Error `storage`.
Expected<void> write_durably(const std::filesystem::path& path, std::string_view text);
/// Which names there are in the folder is on the disk when it returns. Error `storage`.
Expected<void> synchronise_folder(const std::filesystem::path& folder);

}  // namespace race::server
