// What commands ask a running server, for `race core` and `race boot`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server {

inline constexpr const char* kDefaultServer = "http://127.0.0.1:8080";

class Arguments;

/// The server that a command asks, and how it prints errors.
struct ServerOptions {
  std::string url = kDefaultServer;
  bool json = false;  // also as JSON to stdout
  std::optional<std::string> token_file, authority;
  /// Declares `--server`, `--ca`, `--token-file` and `--json`; `json_help` says what is printed then.
  void declare(Arguments& arguments, const std::string& json_help);
};

/// The token in this file, else in the variable RACE_TOKEN of the environment; empty: there is none. Errors: those of
/// read_token_file().
Expected<std::string> token_of(const std::optional<std::string>& file);

/// Sends a request and returns the body of its answer. Otherwise prints why not, and gives the exit code:
/// kExitFindings if the server refuses, with its errors; kExitBadInput if no server answers at the URL.
tl::expected<Value, int> ask_server(const ServerOptions& server, std::string_view method, const std::string& target,
                                    const std::optional<Value>& body = {});

}  // namespace race::server
