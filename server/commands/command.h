// The commands of the program `race`: one function each, in a file of its own or of its kind. Exit codes: 0 fine, 1 the
// run or check found something, 2 bad input.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/store/read_file.h"

namespace race::server {

inline constexpr int kExitOk = 0;
inline constexpr int kExitFindings = 1;  // faulted, property violated
inline constexpr int kExitBadInput = 2;

/// What a command is called by and does. All that is told of how it is used stands here.
struct Command {
  std::string_view name, arguments, text;
  int (*run)(const std::vector<std::string>& words);  // gets the words after the command's name
  std::string (*options)() = nullptr;                 // what they mean, a line each; none: they speak for themselves
};

extern const Command kServe, kService, kRun, kDerive, kCheck, kTranslate, kFmt;

/// Prints errors as `path: code: message` to stderr, with `json` also as {"errors": [...]} to stdout. Returns
/// kExitBadInput.
int refuse(const std::vector<Error>& errors, bool json = false);
int refuse(const Error& error, bool json = false);
/// How a command is called, and what its options mean.
std::string usage(const Command& command);
/// Prints the usage to stderr. Returns kExitBadInput.
int misused(const Command& command);
/// Runs the command that `words` begins with, or prints to stdout how commands are used, if that is what is asked for
/// (`help`, `--help`, `-h`, before or after a command's name). What is no command: kExitBadInput, and the same to
/// stderr.
int run_command(std::span<const Command* const> commands, const std::vector<std::string>& words);

}  // namespace race::server
