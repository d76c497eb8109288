// The configuration file of `race serve`: lines `key = value`, where a key is a long option without its dashes and a
// value is written as on the command line (of a flag: true or false). A line that begins with # is a comment. A text
// that begins as JSON does is that: api/schemas/server_config.json.
//
// Threads: any.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/commands/file_errors.h"
#include "server/commands/settings.h"

namespace race::server {

class Arguments;

/// Reads the text of `file` into `values`. What `arguments` was given as an option stays, but is read and checked all
/// the same. All errors, of lines with FILE:LINE as the file and the key as the path: `syntax` (no `key = value`),
/// `unknown_field`, `duplicate`, `missing` (an empty value), `type`, `out_of_range`, `not_found` (a component group),
/// `not_accepted` (the standard input as a file), `encoding`; of JSON as read_settings().
std::vector<FileErrors> read_config(const std::string& file, std::string_view text, const Arguments& arguments,
                                    Settings& values);

}  // namespace race::server
