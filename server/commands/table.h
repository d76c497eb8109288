// The table of the program's commands: what `race --help`, the manual page and completion list, in this order.
#pragma once

#include <span>

#include "server/commands/command.h"

namespace race::server {

/// All commands of this program. Of the program itself, not of a library: table.cpp names every command.
std::span<const Command* const> all_commands();

}  // namespace race::server
