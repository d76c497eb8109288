// What commands ask a running server: its options, who asks, and how its refusals are printed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/value/expected.h"
#include "core/value/value.h"
#include "server/http/client.h"

namespace race::server {

inline constexpr const char* kDefaultServer = "http://127.0.0.1:8080";

class Arguments;

/// The server that a command asks, and how it prints errors.
struct ServerOptions {
  std::string url = kDefaultServer;
  bool json = false;  // also as JSON to stdout
  std::optional<std::string> token_file, authority;
  bool anonymous = false;  // sends no token: for what needs none, and must not fail for want of a good one
  /// Declares `--server`, `--ca` and `--token-file`.
  void declare(Arguments& arguments);
  /// The same, and `--json`; `json_help` says what is printed then.
  void declare(Arguments& arguments, const std::string& json_help);
  /// Both without `--token-file`.
  void declare_place(Arguments& arguments);
  void declare_place(Arguments& arguments, const std::string& json_help);
};

/// The token in this file, else in the variable RACE_TOKEN of the environment; empty: there is none. Errors: those of
/// read_token_file().
Expected<std::string> token_of(const std::optional<std::string>& file);

/// A client of the server, with the token of who asks: in the file, else in RACE_TOKEN, else the one that `race login`
/// keeps for exactly this server (kept_token.h). Errors: the URL is none, `--ca` does not fit it, or there is a token
/// that cannot be read; with the option or the file as path.
Expected<HttpClient> client_of(const ServerOptions& server, HttpClient::Timeouts timeouts = {});

/// Sends a request and returns its answer, whatever its status. If no server answers at the URL, prints why, and gives
/// kExitBadInput.
tl::expected<HttpClient::Answer, int> request_server(const ServerOptions& server, std::string_view method,
                                                     const std::string& target, const std::optional<Value>& body = {},
                                                     const HttpClient::Headers& headers = {});

/// Prints the errors of an answer that refuses; of one that does not know who asks, also how to log in. `file`: that
/// they are about. Returns kExitFindings.
int refuse_answer(const ServerOptions& server, const HttpClient::Answer& answer, const std::string& file = "");

/// The same of an error of HttpClient::follow(). Gives kExitFindings if the server does not let in who asks, else
/// kExitBadInput.
int refuse_connection(const ServerOptions& server, const Error& error);

/// Whether the server does what it was asked for.
inline bool is_fine(const HttpClient::Answer& answer) { return answer.status >= 200 && answer.status < 300; }

/// Sends a request and returns the body of its answer. Otherwise prints why not, and gives the exit code:
/// kExitFindings if the server refuses, with its errors; kExitBadInput if no server answers at the URL.
tl::expected<Value, int> ask_server(const ServerOptions& server, std::string_view method, const std::string& target,
                                    const std::optional<Value>& body = {});

/// A text of a server in one line, whatever it says: a blank for each is_control() of server/log.
std::string in_one_line(std::string_view text);

}  // namespace race::server
