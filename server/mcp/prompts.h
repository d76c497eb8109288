// Prompts: what a person may begin with.
#pragma once

#include "server/mcp/context.h"
#include "server/mcp/json_rpc.h"

namespace race::server::mcp {

/// prompts/list
tl::expected<Value, RpcError> list_prompts(const Context& context, const Value& params);
/// prompts/get. Error `invalid_params`: there is no such prompt, or its argument is missing.
tl::expected<Value, RpcError> get_prompt(const Context& context, const Value& params);

}  // namespace race::server::mcp
