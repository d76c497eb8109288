// Resources: what clients can put before a model without a call of a tool: documents, rules, skills, the cell.
#pragma once

#include "server/mcp/context.h"
#include "server/mcp/json_rpc.h"

namespace race::server::mcp {

/// resources/list: a page; the first one also has what is no document. Error `invalid_params`: the cursor.
tl::expected<Value, RpcError> list_resources(const Context& context, const Value& params);
/// resources/templates/list
tl::expected<Value, RpcError> list_resource_templates(const Context& context, const Value& params);
/// resources/read. Errors: `no_resource`; `internal`, with the errors of the server, or `too_large`.
tl::expected<Value, RpcError> read_resource(const Context& context, const Value& params);

}  // namespace race::server::mcp
