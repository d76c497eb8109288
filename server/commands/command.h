// The commands of the program `race`: each declares its arguments and what runs it, in a file of its own or of its
// kind. Exit codes: 0 fine; 1 the run or check found something, or a server that was asked refuses; 2 bad input: a
// command line that is wrong, a file that cannot be read or is no document, a document that cannot run, no server; and
// memory or threads that cannot be had.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/commands/arguments.h"
#include "server/commands/file_errors.h"

namespace race::server {

inline constexpr int kExitOk = 0;
inline constexpr int kExitFindings = 1;  // faulted, violations, damage
inline constexpr int kExitBadInput = 2;

struct Command {
  std::string_view name, text;
  /// Declares the arguments, which outlive what is returned: it runs the command once they are parsed, and gives its
  /// exit code.
  std::function<int()> (*declare)(Arguments& arguments);
};

extern const Command kAccount, kBackup, kRestore, kCore, kBoot, kLogin, kLogout, kModels, kPull, kPush, kBundle,
    kInstall;
extern const Command kStart, kStop, kServices, kCall, kTrace, kLog, kCompletion, kMcp;
extern const Command kServe, kService, kRun, kTest, kRuns, kReplay, kDerive, kCheck, kTranslate, kFmt, kMan;

/// Prints errors as lines to stderr, with `json` also as JSON to stdout (file_errors.h). Returns kExitBadInput.
int refuse(std::span<const FileErrors> errors, bool json = false);
int refuse(const FileErrors& errors, bool json = false);
/// Of no file.
int refuse(const std::vector<Error>& errors, bool json = false);
int refuse(const Error& error, bool json = false);
/// Runs the command that `words` begins with. Prints to stdout how commands are used, if that is what is asked for
/// (`help`, `--help`, `-h`, before or after a command's name), or the version (`--version`). What is no command:
/// kExitBadInput, with the command that is probably meant, or the usage, on stderr.
int run_command(std::span<const Command* const> commands, std::vector<std::string> words);

}  // namespace race::server
