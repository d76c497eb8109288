// The command line of a service, and the token that it has.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/value/expected.h"
#include "services/remote/address.h"

namespace race::client {

struct Options {
  std::string server = "http://127.0.0.1:8080";
  remote::Address address;
  std::optional<std::string> token_file;
  bool help = false;  // is to be printed
};

inline constexpr const char* kHelp =
    "Offers services at a server of RACE.\n"
    "  --server URL        where it runs (http://127.0.0.1:8080)\n"
    "  --token-file FILE   the token of the process; else RACE_TOKEN, else data/processes.token";

/// Reads the arguments behind the name of the program. Errors, with the option or URL as path: `syntax`, `missing`,
/// `not_accepted`.
Expected<Options> read_options(const std::vector<std::string>& arguments);

/// The token in the file, else in the variable RACE_TOKEN, else in the file that a server in the same folder makes for
/// processes of its own user; empty: there is none. Errors, with the file or variable as path: `io`, `not_accepted`.
Expected<std::string> find_token(const std::optional<std::string>& file);

}  // namespace race::client
