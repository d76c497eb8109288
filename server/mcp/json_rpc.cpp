#include "server/mcp/json_rpc.h"

#include "core/value/error_list.h"
#include "core/value/fields.h"
#include "server/wire/errors.h"

namespace race::server::mcp {
namespace {

tl::unexpected<Refusal> no_message(Value id, Error error, RpcCode code = RpcCode::invalid_request) {
  return tl::unexpected(Refusal{std::move(id), make_rpc_error(code, {std::move(error)})});
}

}  // namespace

RpcError make_rpc_error(RpcCode code, const std::vector<Error>& errors) {
  RpcError made{code, ""};
  for (const Error& error : errors) add_error(made.errors, error);
  const Error& first = made.errors.front();
  made.message = first.path.empty() ? first.message : first.path + ": " + first.message;
  return made;
}

bool is_id(const Value& value) {
  return value.is_numeric() || (value.is_string() && value.as_string().size() <= kMaxId);
}

tl::expected<std::optional<Message>, Refusal> read_message(const Value& json) {
  if (!json.is_dict())
    return no_message({}, {ErrorCode::type, "must be an object, got " + std::string(kind_name(json))});
  const Value* id = json.find("id");
  const Value known = id && is_id(*id) ? *id : Value();
  const Value* version = json.find("jsonrpc");
  if (!version || *version != Value("2.0")) return no_message(known, {ErrorCode::version, "must be `2.0`", "jsonrpc"});
  if (id && !is_id(*id))
    return no_message({}, {ErrorCode::type, "must be a number, or a string of at most 1024 bytes", "id"});
  const Value* method = json.find("method");
  if (!method && id && (json.find("result") || json.find("error"))) return std::nullopt;
  if (!method || !method->is_string()) return no_message(known, {ErrorCode::type, "must be a string", "method"});
  const Value* params = json.find("params");
  if (params && !params->is_dict() && !id) return std::nullopt;  // a notification is never answered
  if (params && !params->is_dict())
    return no_message(known, {ErrorCode::type, "must be an object", "params"}, RpcCode::invalid_params);
  Message message{id ? std::optional(known) : std::nullopt, method->as_string(), params ? *params : Value(Dict())};
  message.params.freeze();  // a thread of its own reads them
  return message;
}

Value make_response(const Value& id, Value result) {
  return Dict{{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
}

Value make_error(const Value& id, const RpcError& error) {
  Dict json{{"code", static_cast<int>(error.code)}, {"message", error.message}};
  if (!error.errors.empty()) json.set("data", errors_json(error.errors));
  return Dict{{"jsonrpc", "2.0"}, {"id", id}, {"error", std::move(json)}};
}

Value make_notification(std::string_view method, Dict params) {
  return Dict{{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

}  // namespace race::server::mcp
