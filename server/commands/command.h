// The commands of the program `race`: one function each, in a file of its own or of its kind. Exit codes: 0 fine, 1 the
// run or check found something, 2 bad input.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "server/store/read_file.h"

namespace race::server {

inline constexpr int kFine = 0;
inline constexpr int kFound = 1;  // faulted, property violated
inline constexpr int kBadInput = 2;

/// A row of the table in main.cpp. `run` gets the words after the command's name.
struct Command {
  std::string_view name, usage, text;
  int (*run)(const std::vector<std::string>& arguments);
};

int serve_command(const std::vector<std::string>& arguments);
int service_command(const std::vector<std::string>& arguments);
int run_command(const std::vector<std::string>& arguments);
int derive_command(const std::vector<std::string>& arguments);
int check_command(const std::vector<std::string>& arguments);
int translate_command(const std::vector<std::string>& arguments);
int fmt_command(const std::vector<std::string>& arguments);

/// Prints errors as `path: code: message` to stderr, with `json` also as {"errors": [...]} to stdout. Returns
/// kBadInput.
int refuse(const std::vector<Error>& errors, bool json = false);
int refuse(const Error& error, bool json = false);
/// Prints how a command is called. Returns kBadInput.
int usage(std::string_view command, std::string_view arguments);

}  // namespace race::server
