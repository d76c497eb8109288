// The commands of the program `race`: each declares its arguments and what runs it, in a file of its own or of its
// kind. Exit codes: 0 fine, 1 the run or check found something, 2 bad input.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/commands/arguments.h"
#include "server/store/files.h"

namespace race::server {

inline constexpr int kExitOk = 0;
inline constexpr int kExitFindings = 1;  // faulted, property violated
inline constexpr int kExitBadInput = 2;

struct Command {
  std::string_view name, text;
  /// Declares the arguments; returns what runs the command once they are parsed, and gives its exit code.
  std::function<int()> (*declare)(Arguments& arguments);
};

extern const Command kBackup, kRestore, kCore, kBoot;
extern const Command kServe, kService, kRun, kRuns, kReplay, kDerive, kCheck, kTranslate, kFmt;

/// Prints errors as `path: code: message` to stderr, with `json` also as {"errors": [...]} to stdout. Returns
/// kExitBadInput.
int refuse(const std::vector<Error>& errors, bool json = false);
int refuse(const Error& error, bool json = false);
/// Runs the command that `words` begins with. Prints to stdout how commands are used, if that is what is asked for
/// (`help`, `--help`, `-h`, before or after a command's name), or the version (`--version`). What is no command:
/// kExitBadInput, and the usage to stderr.
int run_command(std::span<const Command* const> commands, std::vector<std::string> words);

}  // namespace race::server
