// The tools: what tools/list and tools/call answer.
#pragma once

#include <span>

#include "server/mcp/json_rpc.h"
#include "server/mcp/tool.h"

namespace race::server::mcp {

/// All of them, in the order in which they are listed.
std::span<const Tool> all_tools();
/// The JSON Schema of the arguments.
Value schema_of(const Tool& tool);

/// tools/list: those that the account may use, as far as the server says so now (GET /api/v1/me).
tl::expected<Value, RpcError> list_tools(const Context& context, const Value& params);
/// tools/call. Error `invalid_params`: there is no such tool, or its arguments are no object. What a model can mend is
/// a result that says so (`isError`): arguments that do not fit, with their paths; what the server refuses; what is
/// larger than kMostText (`too_large`).
tl::expected<Value, RpcError> call_tool(const Context& context, const Value& params);

/// Whether tools/call with these parameters stops something, and so must wait for no other call.
bool calls_stop(const Value& params);

/// An outcome as a result of tools/call.
Value tool_result(const Outcome& outcome);

}  // namespace race::server::mcp
