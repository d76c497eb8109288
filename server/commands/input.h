// What commands read: a file, or the standard input in its place.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/execution/journal.h"
#include "core/value/expected.h"

namespace race::server {

/// The name of a file that stands for the standard input. A command line has it once at most (arguments.h).
inline constexpr std::string_view kStandardInput = "-";

/// The largest text that a command reads [bytes]: a journal. Readers of smaller documents have limits of their own.
inline constexpr std::size_t kMaxInput = execution::kJournalLimits.bytes;

/// The text of the file, or of the standard input. Errors, with an empty path: `io` (it cannot be read), `too_large`;
/// no more than that is read then.
Expected<std::string> read_input(const std::string& file);

}  // namespace race::server
