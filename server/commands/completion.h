// What a shell offers for a command line of `race` that is not complete.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/commands/command.h"

namespace race::server {

struct Completion {
  enum class Kind : std::uint8_t { words, files, folders };  // files and folders: of the shell, which knows them
  Kind kind = Kind::words;
  std::vector<std::string> words = {};  // that begin as what is typed
};

/// Names that a server has, for what the help of a command calls DOCUMENT, ID or SERVICE.OPERATION.
using NamesAtServer = std::function<std::vector<std::string>(std::string_view placeholder)>;

/// `words`: after `race`; the last is being typed, and may be empty. At least one.
Completion complete(std::span<const Command* const> commands, const std::vector<std::string>& words,
                    const NamesAtServer& names);

}  // namespace race::server
