// JSON-RPC 2.0 as the Model Context Protocol has it: messages as they are read, and answers as they are written. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value/expected.h"
#include "core/value/value.h"

namespace race::server::mcp {

/// Codes of errors: of JSON-RPC, of the protocol (kNoResource), and one of ours, as JSON-RPC leaves -32000 to servers.
enum class RpcCode : int {
  parse = -32700,
  invalid_request = -32600,
  no_method = -32601,
  invalid_params = -32602,
  internal = -32603,
  no_resource = -32002,
  busy = -32000,
};

/// Why a request is not answered with a result. `errors`, with paths and codes, go into its `data`.
struct RpcError {
  RpcCode code;
  std::string message;
  std::vector<Error> errors = {};
};

/// Its message is that of the first error, with its path. What the client has made long is cut (error_list.h). Requires
/// an error.
RpcError make_rpc_error(RpcCode code, const std::vector<Error>& errors);

/// A request, or, without an id, a notification.
struct Message {
  std::optional<Value> id;  // a string or a number
  std::string method;
  Value params;  // an object
};

/// What is no message, with its id if that is known, else null.
struct Refusal {
  Value id;
  RpcError error;
};

/// The most that an id or a token of the client may have [bytes].
inline constexpr std::size_t kMaxId = 1024;
/// Whether it is one: a number or a string that is not too long.
bool is_id(const Value& value);

/// Reads a message. Nothing: it is a response, and we ask nothing. Refused with `invalid_request` and the path of the
/// field, or `invalid_params` if only `params` are no object.
tl::expected<std::optional<Message>, Refusal> read_message(const Value& json);

Value make_response(const Value& id, Value result);
Value make_error(const Value& id, const RpcError& error);
Value make_notification(std::string_view method, Dict params);

}  // namespace race::server::mcp
