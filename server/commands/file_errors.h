// Errors by the file that they are in, and how every command prints them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

/// What is wrong in a file; their paths are places in it. Without a file: with the command line, or what it names.
struct FileErrors {
  std::string file;  // as the command line has it; `-` is the standard input
  std::vector<Error> errors;
};

/// `FILE: path: code: message`, in one line; without a file or a path, the rest.
std::string error_line(const std::string& file, const Error& error);

/// The line after the errors of a file that has more than kMaxErrors, which are not listed.
inline constexpr const char* kMoreErrors = "there are more errors, which are not listed";

/// Prints each error to stderr as a line.
void print_errors(std::span<const FileErrors> all);

/// {"errors": [{"file", "path", "code", "message"}]}, with `file` where there is one, and the code text that it is
/// about (`id`, `text`, `line`, `column`) where it is known; if there are more than kMaxErrors in a file, these alone,
/// and `more_errors`, which is true.
Value file_errors_json(std::span<const FileErrors> all);

}  // namespace race::server
