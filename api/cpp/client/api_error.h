// ApiError: why a request is not done, or is not known to be done.
//
// Threads: a value; each belongs to one.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::client {

// Codes that are not the server's; all others are (api/openapi.yaml names them by route).
inline constexpr std::string_view kConnection = "connection";  // there is no connection, or it ended
inline constexpr std::string_view kTimeout = "timeout";        // what was waited for did not come in time
inline constexpr std::string_view kProtocol = "protocol";      // what came is not what api/ promises, or is not trusted
inline constexpr std::string_view kArgument = "argument";      // nothing was sent, as this cannot be

struct ApiError {
  int status = 0;                   // of HTTP, with which the server refuses; 0: no refusal has come by HTTP
  std::string code, path, message;  // of the first of `errors`; a program branches on `code`
  List errors = {};          // at least one, each with path, code and message; of code text also text, line, column
  bool more_errors = false;  // there are more
  bool may_be_done = false;  // it was or may have been sent, and no answer has come that can be read
  /// Of a service that has answered a call with an error (status 200): the call, and the whole error. Else empty.
  std::string service = {}, operation = {};
  Value error = {};
};

template <typename T>
using Answered = tl::expected<T, ApiError>;

/// An error that is not the server's.
tl::unexpected<ApiError> failure(std::string_view code, std::string message, bool may_be_done = false);

/// That of HttpClient: `unavailable` is kConnection, all else kProtocol.
ApiError connection_error(const Error& error);

/// Of problem details (api/schemas/problem.json), with which a server refuses, or of what should be some. `status`: 0
/// on the stream.
ApiError refusal(int status, const Value& problem);

/// `path: code: message` of each error, a line each, as `race` prints them.
std::string to_string(const ApiError& error);

}  // namespace race::client
